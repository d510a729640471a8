// The chart of error against cost, by Chart.js. Without that library the page names the front in
// words, and the table marks it.
'use strict';

const plot = {chart: null, front: []};

const cssColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// On a logarithmic axis 0 has no place: it, and what the table shows as 0, is drawn at a third of
// the least of the others.
const leastShown = (column) => 0.5 * 10 ** -column.digits;
function floorOf(column, rows) {
  const shown = rows.map(column.value).filter((value) => value >= leastShown(column));
  return shown.length ? Math.min(...shown) / 3 : 1;
}

function axis(title, logarithmic) {
  const color = cssColor('--quiet');
  return {type: logarithmic ? 'logarithmic' : 'linear', grid: {color: cssColor('--line')},
          ticks: {color, maxTicksLimit: 8, callback: (value) => Number(value.toPrecision(3))},
          title: {display: true, text: title, color}};
}

// Names beside the points of the front.
const frontNames = {
  id: 'frontNames',
  afterDatasetsDraw(chart) {
    const context = chart.ctx;
    context.save();
    context.font = '12px system-ui, sans-serif';
    context.fillStyle = cssColor('--text');
    chart.getDatasetMeta(1).data.forEach((element, index) => {
      const {label} = chart.data.datasets[1].data[index];
      const right = element.x + 8 + context.measureText(label).width > chart.chartArea.right;
      context.textAlign = right ? 'right' : 'left';
      context.fillText(label, element.x + (right ? -8 : 8), element.y - 8);
    });
    context.restore();
  },
};

function chartOptions(x, y, logarithmic, onPick) {
  return {
    animation: false,
    maintainAspectRatio: false,
    scales: {x: axis(x.title, logarithmic), y: axis(y.title, logarithmic)},
    onClick: (event, elements) => {
      if (elements.length) onPick('a', elements[0].element.$context.raw.key);
    },
    plugins: {
      legend: {labels: {color: cssColor('--text'), usePointStyle: true}},
      tooltip: {callbacks: {label: ({raw}) => `${raw.label}: ${y.title} ` +
          `${numberText(raw.error, y.digits)}, ${x.title} ${numberText(raw.cost, x.digits)}`}},
    },
  };
}

function drawPlot(onPick) {
  const x = columnOf(byId('chart-x').value), y = columnOf(byId('chart-y').value);
  const logarithmic = byId('chart-log').checked;
  const known = data.results.filter((row) => isNumber(x.value(row)) && isNumber(y.value(row)));
  const front = paretoFront(known, x, y);
  plot.front = front.map((row) => row.key);
  byId('front').textContent = `◆ Nothing else has both less ${y.title} and less ${x.title}: ` +
      `${front.map((row) => row.label).join('; ')}.` +
      (logarithmic && known.some((row) => y.value(row) < leastShown(y)) ?
           ' What is 0 stands at the lower edge of the logarithmic axis.' : '');
  if (typeof Chart === 'undefined') {
    byId('chart').parentElement.hidden = true;
    return;
  }
  const lowX = floorOf(x, known), lowY = floorOf(y, known);
  const place = (value, low) => (logarithmic ? Math.max(value, low) : value);
  const point = (row) => ({x: place(x.value(row), lowX), y: place(y.value(row), lowY),
                           key: row.key, label: row.label, cost: x.value(row),
                           error: y.value(row)});
  if (plot.chart) plot.chart.destroy();
  plot.chart = new Chart(byId('chart'), {
    type: 'scatter',
    data: {datasets: [
      {label: 'others', data: known.filter((row) => !front.includes(row)).map(point),
       backgroundColor: cssColor('--accent'), pointRadius: 5},
      {label: 'Pareto front', data: front.map(point), showLine: true, stepped: true,
       borderColor: cssColor('--other'), backgroundColor: cssColor('--other'), borderWidth: 1.5,
       pointStyle: 'rectRot', pointRadius: 7},
    ]},
    options: chartOptions(x, y, logarithmic, onPick),
    plugins: [frontNames],
  });
}

function startPlot(onPick) {
  for (const column of columns) {
    const option = () => make('option', {value: column.id}, column.title);
    if (column.error) byId('chart-y').append(option());
    if (column.cost) byId('chart-x').append(option());
  }
  byId('chart-y').value = 'rmse_same_s';
  const redraw = () => {
    drawPlot(onPick);
    markRows();
  };
  for (const id of ['chart-x', 'chart-y', 'chart-log']) byId(id).addEventListener('change', redraw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  drawPlot(onPick);
}
