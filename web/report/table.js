// The table of results: sorted by any column, filtered by words.
'use strict';

const table = {sort: 'rmse_same_s', descending: false, onPick: null};

const nameColumn = {id: 'name', title: 'method', value: (row) => row.label};

function headerCell(column) {
  const button = make('button', {type: 'button', title: column.meaning || ''}, column.title);
  button.addEventListener('click', () => {
    table.descending = table.sort === column.id && !table.descending;
    table.sort = column.id;
    fillTable();
  });
  return make('th', {scope: 'col', 'data-column': column.id}, button);
}

function pickButton(side, row) {
  const button = make('button', {type: 'button', 'aria-label': `Show ${row.label} as ${side}`,
                                 'data-side': side}, side);
  button.addEventListener('click', () => table.onPick(side.toLowerCase(), row.key));
  return button;
}

// Numbers by size, with what is unknown last whichever way; names by the alphabet.
function compareRows(column, a, b) {
  const x = column.value(a), y = column.value(b);
  if (column === nameColumn) return x.localeCompare(y) * (table.descending ? -1 : 1);
  if (!isNumber(x) || !isNumber(y)) return isNumber(y) - isNumber(x);
  return table.descending ? y - x : x - y;
}

// Those that the filter's words leave.
function filteredRows() {
  const words = byId('filter').value.toLowerCase().split(/\s+/).filter(Boolean);
  return data.results.filter((row) => {
    const text = `${row.name} ${row.samples}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

function rowElement(row) {
  const cells = columns.map(
      (column) => make('td', {}, numberText(column.value(row), column.digits)));
  return make('tr', {'data-key': row.key}, make('th', {scope: 'row'}, row.label),
              make('td', {}, pickButton('A', row), ' ', pickButton('B', row)), ...cells);
}

function fillTable() {
  const column = [nameColumn, ...columns].find((c) => c.id === table.sort);
  const rows = filteredRows();
  rows.sort((a, b) => compareRows(column, a, b));
  byId('results').tBodies[0].replaceChildren(...rows.map(rowElement));
  for (const th of byId('results').tHead.querySelectorAll('th[data-column]')) {
    const sorted = th.dataset.column === table.sort;
    th.setAttribute('aria-sort',
                    !sorted ? 'none' : table.descending ? 'descending' : 'ascending');
  }
  byId('shown').textContent = rows.length === data.results.length ?
      `${rows.length} results` : `${rows.length} of ${data.results.length} results`;
  markRows();
}

// What the viewer shows, and what the chart's front holds.
function markRows() {
  for (const tr of byId('results').tBodies[0].rows) {
    tr.classList.toggle('front', plot.front.includes(tr.dataset.key));
    for (const button of tr.querySelectorAll('button')) {
      const shown = viewer[button.dataset.side.toLowerCase()] === tr.dataset.key;
      button.setAttribute('aria-pressed', String(shown));
    }
  }
}

function startTable(onPick) {
  table.onPick = onPick;
  byId('results').tHead.append(make('tr', {}, headerCell(nameColumn),
                                    make('th', {scope: 'col'}, 'show'),
                                    ...columns.map(headerCell)));
  for (const column of columns) {
    byId('meanings').append(make('dt', {}, column.title), make('dd', {}, column.meaning));
  }
  byId('filter').addEventListener('input', fillTable);
  fillTable();
}
