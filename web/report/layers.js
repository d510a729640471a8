// What a pixel sees, near to far: the transmittance behind each of its fragments. Known for a grid
// of pixels; the one nearest to the chosen pixel is shown.
'use strict';

const layers = {chart: null};

// Its number.
function nearestProbe(x, y) {
  const distance = ([px, py]) => (px - x) ** 2 + (py - y) ** 2;
  return data.probes.reduce(
      (best, probe, i) => (distance(probe) < distance(data.probes[best]) ? i : best), 0);
}

const stepOf = ([depth, behind, opacity, coverage, ...color]) =>
    ({depth, behind, opacity, coverage, color: `rgb(${color.join(' ')})`});

function layerRow(step, index) {
  const swatch = make('span', {className: 'swatch'});
  swatch.style.background = step.color;
  return make('tr', {}, make('th', {scope: 'row'}, swatch, ` ${index + 1}`),
              ...[step.depth, step.opacity, step.coverage, step.behind].map(
                  (value) => make('td', {}, String(value))));
}

function drawLayers() {
  if (data.probes.length === 0) return;
  const probe = nearestProbe(viewer.x, viewer.y);
  const [x, y, list, tooMany] = data.probes[probe];
  const steps = list.map(stepOf);
  const none = tooMany ? 'more layers than the memory limit has room for' : 'nothing transparent';
  byId('probe-title').textContent = steps.length === 0 ?
      `Pixel ${x}, ${y}, the nearest of a grid: ${none}.` :
      `Pixel ${x}, ${y}, the nearest of a grid: ${steps.length} transparent fragments let ` +
      `${(100 * steps.at(-1).behind).toPrecision(3)} % of the light behind them through.`;
  byId('layers').tBodies[0].replaceChildren(...steps.map(layerRow));
  if (layers.chart) layers.chart.destroy();
  layers.chart = null;
  byId('probe').parentElement.hidden = typeof Chart === 'undefined' || steps.length === 0;
  if (byId('probe').parentElement.hidden) return;
  const point = (step) => ({x: step.depth, y: step.behind, step});
  const span = steps.at(-1).depth - steps[0].depth || 1;
  const start = {x: steps[0].depth - 0.05 * span, y: 1};
  const end = {x: steps.at(-1).depth + 0.05 * span, y: steps.at(-1).behind};
  const bounds = {x: {min: start.x, max: end.x}, y: {min: 0, max: 1}};
  const axes = {x: axis('depth', false), y: axis('transmittance in front', false)};
  layers.chart = new Chart(byId('probe'), {
    type: 'scatter',
    data: {datasets: [{
      label: 'exact', data: [start, ...steps.map(point), end], showLine: true, stepped: 'before',
      borderColor: cssColor('--accent'), borderWidth: 1.5,
      pointBackgroundColor: ['transparent', ...steps.map((s) => s.color), 'transparent'],
      pointBorderColor: cssColor('--text'), pointRadius: [0, ...steps.map(() => 4), 0],
    }, ...curveDatasets(probe)]},
    options: {
      animation: false,
      maintainAspectRatio: false,
      scales: {x: {...axes.x, ...bounds.x}, y: {...axes.y, ...bounds.y}},
      plugins: {
        legend: {display: data.curves.methods.length > 0,
                 labels: {color: cssColor('--text'), usePointStyle: true, pointStyle: 'line'}},
        tooltip: {filter: ({raw}) => Boolean(raw.step),
                  callbacks: {label: ({raw}) => `depth ${raw.step.depth}, opacity ` +
                      `${raw.step.opacity}, behind it ${raw.step.behind}`}},
      },
    },
  });
}

function startLayers() {
  const heads = ['', 'depth', 'opacity', 'coverage', 'transmittance behind'];
  byId('layers').tHead.append(
      make('tr', {}, ...heads.map((head) => make('th', {scope: 'col'}, head))));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawLayers);
  startCurves(drawLayers);
  drawLayers();
}
