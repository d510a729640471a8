// What methods take the transmittance of the probes' pixels for, over the layers' own: lines that
// can be chosen, of those that keep a function of depth.
'use strict';

const CURVE_COLORS = ['--other', '--third', '--fourth', '--fifth', '--quiet'];
const CURVE_DASHES = [[], [6, 3], [2, 3]];
const MOST_CURVES_AT_FIRST = 4;

const curves = {shown: new Set(data.curves.methods.slice(0, MOST_CURVES_AT_FIRST))};

// Of the probe with that number; values are whole thousandths.
function curveDatasets(probe) {
  const [distances, ...values] = data.curves.pixels[probe];
  return data.curves.methods.map((method, m) => ({
    label: method, showLine: true, pointRadius: 0, borderWidth: 1.5,
    hidden: !curves.shown.has(method),
    borderColor: cssColor(CURVE_COLORS[m % CURVE_COLORS.length]),
    borderDash: CURVE_DASHES[Math.floor(m / CURVE_COLORS.length) % CURVE_DASHES.length],
    data: distances.map((x, i) => ({x, y: values[m][i] / 1000})),
  })).filter((set) => !set.hidden);
}

function startCurves(redraw) {
  byId('curve-methods').hidden = data.curves.methods.length === 0 || typeof Chart === 'undefined';
  for (const method of data.curves.methods) {
    const box = make('input', {type: 'checkbox', value: method, checked: curves.shown.has(method)});
    box.addEventListener('change', () => {
      curves.shown[box.checked ? 'add' : 'delete'](method);
      redraw();
    });
    byId('curve-methods').append(make('label', {}, box, ` ${method}`));
  }
}
