// Where the errors are: by what a pixel's transparent fragments are like. A row of cells for each
// result that the table's filter leaves, the darker the larger, and the two results of the pictures
// as lines.
'use strict';

const failures = {chart: null};

const scaleOf = () => data.failures.find((scale) => scale.id === byId('kind').value);

// The largest error of the table has the deepest colour, 0 has none.
function failureCell(value, most) {
  const cell = make('td', {}, numberText(value, 3));
  const part = isNumber(value) && most > 0 ? value / most : 0;
  cell.style.background =
      `color-mix(in srgb, var(--other) ${(60 * Math.sqrt(part)).toFixed(1)}%, transparent)`;
  return cell;
}

function fillFailures(scale) {
  const all = data.width * data.height;
  const heads = scale.bands.map(({name, pixels}) => make('th', {scope: 'col'}, name, make('br'),
      make('small', {}, `${(100 * pixels / all).toFixed(1)} %`)));
  byId('failures').tHead.replaceChildren(make('tr', {}, make('th', {scope: 'col'}, 'method'),
                                              ...heads));
  const rows = filteredRows().sort((a, b) => a.rmse_same_s - b.rmse_same_s);
  const most = Math.max(...data.results.flatMap((row) => row.failures[scale.id].filter(isNumber)));
  byId('failures').tBodies[0].replaceChildren(...rows.map((row) => make(
      'tr', {'data-key': row.key}, make('th', {scope: 'row'}, row.label),
      ...row.failures[scale.id].map((value) => failureCell(value, most)))));
}

// Bands that no pixel falls into are left out of the chart.
function failureLines(scale) {
  const shown = scale.bands.map((_, index) => index).filter((i) => scale.bands[i].pixels > 0);
  const picked = [['a', '--accent'], ['b', '--other']].filter(([side]) => viewer[side] !== 'truth');
  return {
    labels: shown.map((i) => scale.bands[i].name),
    datasets: picked.map(([side, color]) => {
      const row = pictureOf(viewer[side]);
      return {label: `${side.toUpperCase()}: ${row.label}`,
              data: shown.map((i) => row.failures[scale.id][i]),
              borderColor: cssColor(color), backgroundColor: cssColor(color), borderWidth: 2};
    }),
  };
}

function drawFailureLines() {
  const scale = scaleOf();
  if (failures.chart) failures.chart.destroy();
  failures.chart = null;
  const lines = failureLines(scale);
  const place = byId('failure-chart').parentElement;
  place.hidden = typeof Chart === 'undefined' || lines.datasets.length === 0;
  if (place.hidden) return;
  const across = axis(scale.title, false), up = axis('rmse same S of these pixels', false);
  failures.chart = new Chart(byId('failure-chart'), {
    type: 'line',
    data: lines,
    options: {
      animation: false,
      maintainAspectRatio: false,
      interaction: {mode: 'nearest', intersect: false},
      scales: {x: {...across, type: 'category', ticks: {color: cssColor('--quiet')}},
               y: {...up, min: 0}},
      plugins: {legend: {labels: {color: cssColor('--text')}}},
    },
  });
}

function drawFailures() {
  fillFailures(scaleOf());
  drawFailureLines();
}

function startFailures() {
  for (const scale of data.failures) {
    byId('kind').append(make('option', {value: scale.id}, scale.title));
  }
  byId('kind').addEventListener('change', drawFailures);
  byId('filter').addEventListener('input', () => fillFailures(scaleOf()));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawFailureLines);
  drawFailures();
}
