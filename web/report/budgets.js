// Equal time, equal memory: the best that each method does within a budget. A method's results are
// those of all its parameters and samples together.
'use strict';

const MOST_BUDGETS = 12;

const budgets = {chart: null};

const methodsOf = (rows) => [...new Set(rows.map((row) => row.method))];

// Powers of two and equal steps between them, the most that are not too many, from the least cost
// to the greatest: of the first, one result or more is within it, and within the last all are.
function budgetsFor(costs) {
  const least = Math.min(...costs.filter((cost) => cost > 0)), most = Math.max(...costs);
  if (!Number.isFinite(least)) return [];
  const between = (steps) => {
    const list = [];
    for (let e = Math.floor(Math.log2(least)); list.length === 0 || list.at(-1) < most; ++e) {
      for (let i = 0; i < steps; ++i) {
        const budget = (1 + i / steps) * 2 ** e;
        if (budget >= least && !(list.at(-1) >= most)) list.push(budget);
      }
    }
    return list;
  };
  const some = [8, 4, 2].map(between).find((list) => list.length <= MOST_BUDGETS);
  return some || between(1);
}

// Less error as it is shown, or as much for less.
const isBetter = (x, y, a, b) =>
    shownValue(y, a) < shownValue(y, b) ||
    (shownValue(y, a) === shownValue(y, b) && x.value(a) < x.value(b));

// Of rows of one method; none where all cost more.
function bestWithin(rows, x, y, budget) {
  const within = rows.filter((row) => x.value(row) <= budget);
  return within.reduce((best, row) => (!best || isBetter(x, y, row, best) ? row : best), null);
}

function budgetTable() {
  const x = columnOf(byId('budget-cost').value), y = columnOf(byId('budget-error').value);
  const known = data.results.filter((row) => isNumber(x.value(row)) && isNumber(y.value(row)));
  const limits = budgetsFor(known.map(x.value));
  const lines = methodsOf(known).map((method) => {
    const rows = known.filter((row) => row.method === method);
    return {method, rows, best: limits.map((budget) => bestWithin(rows, x, y, budget))};
  });
  const winners = limits.map((_, i) => lines.map((line) => line.best[i]).filter(Boolean)
      .reduce((a, b) => (isBetter(x, y, b, a) ? b : a)));
  const last = (line) => line.best.findLast(Boolean);
  lines.sort((a, b) => y.value(last(a)) - y.value(last(b)));
  return {x, y, limits, lines, winners};
}

const budgetText = (budget) => String(Number(budget.toPrecision(9)));

const valueText = (column, row) =>
    `${column.title} ${numberText(column.value(row), column.digits)}`;

function budgetRow({y, winners}, line) {
  return make('tr', {}, make('th', {scope: 'row'}, line.method), ...line.best.map((row, i) => {
    const best = row !== null && shownValue(y, row) === shownValue(y, winners[i]);
    return make('td', {className: best ? 'best' : '', title: row ? row.label : ''},
                row ? numberText(y.value(row), y.digits) : '–');
  }));
}

// In words, where the winner changes.
function winnersText({x, y, limits, winners}) {
  if (winners.length === 0) return `No result has both ${x.title} and ${y.title}.`;
  const changes = winners.map((row, i) => ({row, budget: limits[i]}))
      .filter(({row}, i) => i === 0 || row !== winners[i - 1]);
  return `◆ Best for ${x.title} of at most ` + changes.map(({row, budget}) =>
      `${budgetText(budget)}: ${row.label} (${numberText(y.value(row), y.digits)})`).join('; ') +
      '.';
}

// A line falls where another result of the method comes within the budget. Methods that win
// somewhere have colours and names, the others are behind them.
function budgetLines({x, y, limits, lines, winners}) {
  const all = lines.flatMap((line) => line.rows);
  const lowX = floorOf(x, all), lowY = floorOf(y, all);
  const colors = ['--accent', '--other', '--third', '--fourth', '--fifth'];
  const winning = methodsOf(winners);
  return lines.map((line) => {
    const place = winning.indexOf(line.method);
    const front = paretoFront(line.rows, x, y);
    const points = front.map((row) => ({x: Math.max(x.value(row), lowX),
                                        y: Math.max(y.value(row), lowY), row}));
    points.push({...points.at(-1), x: limits.at(-1)});
    const color = cssColor(place < 0 ? '--line' : colors[place % colors.length]);
    return {label: line.method, data: points, showLine: true, stepped: 'before', wins: place >= 0,
            borderColor: color, backgroundColor: color, borderWidth: place < 0 ? 1 : 2,
            pointRadius: points.map((_, i) => (i + 1 === points.length ? 0 : 3)),
            order: place < 0 ? 1 : 0};
  });
}

function drawBudgetChart(table) {
  if (budgets.chart) budgets.chart.destroy();
  budgets.chart = null;
  const place = byId('budget-chart').parentElement;
  place.hidden = typeof Chart === 'undefined';
  if (place.hidden) return;
  const {x, y} = table;
  budgets.chart = new Chart(byId('budget-chart'), {
    type: 'scatter',
    data: {datasets: budgetLines(table)},
    options: {
      animation: false,
      maintainAspectRatio: false,
      scales: {x: axis(`${x.title}, at most`, true), y: axis(y.title, true)},
      plugins: {
        legend: {labels: {color: cssColor('--text'), usePointStyle: true,
                          filter: (item, {datasets}) => datasets[item.datasetIndex].wins}},
        tooltip: {callbacks: {label: ({raw: {row}}) => `${row.label}: ${valueText(y, row)}, ` +
            valueText(x, row)}},
      },
    },
  });
}

function drawBudgets() {
  const table = budgetTable();
  byId('budgets').tHead.replaceChildren(make(
      'tr', {}, make('th', {scope: 'col'}, `${table.x.title}, at most`),
      ...table.limits.map((budget) => make('th', {scope: 'col'}, budgetText(budget)))));
  byId('budgets').tBodies[0].replaceChildren(...table.lines.map((line) => budgetRow(table, line)));
  byId('budget-best').textContent = winnersText(table);
  drawBudgetChart(table);
}

function startBudgets() {
  for (const column of columns) {
    const option = () => make('option', {value: column.id}, column.title);
    if (column.cost) byId('budget-cost').append(option());
    if (column.error) byId('budget-error').append(option());
  }
  byId('budget-error').value = 'rmse_same_s';
  for (const id of ['budget-cost', 'budget-error']) {
    byId(id).addEventListener('change', drawBudgets);
  }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawBudgets);
  drawBudgets();
}
