// The report's numbers: its table and its chart against what was measured.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

export const METHODS = 'blend,exact,stochastic:masks=naive,wboit,weighted-average,adaptive';

const column = (page, id) => page.$$eval(
    '#results thead th', (heads, want) => heads.findIndex((h) => h.dataset.column === want), id);

export async function cells(page, id) {
  const index = await column(page, id);
  return page.$$eval('#results tbody tr', (rows, i) => rows.map((row) => row.cells[i].textContent),
                     index);
}

// The columns, each with what metrics.json has for it, in the digits of the page.
export const COLUMNS = {
  samples: [0, (row) => row.samples],
  rmse: [3, (row) => row.rmse],
  rmse_same_s: [3, (row) => row.rmse_same_s],
  psnr: [2, (row) => row.psnr],
  ssim: [4, (row) => row.ssim],
  flip: [4, (row) => row.flip],
  bias: [3, (row) => row.bias],
  noise: [3, (row) => row.noise],
  ratio_to_blend: [2, (row) => row.ratio_to_blend],
  ms: [1, (row) => row.ms.total],
  bytes_per_pixel: [0, (row) => row.bytes_per_pixel],
  peak_memory: [1, (row) => row.peak_memory_bytes / 2 ** 20],
};

// compare's rows stand in the order of --samples, then of --methods.
export function nameOf(index, metrics) {
  const methods = METHODS.split(',');
  return `${methods[index % methods.length]}, ${metrics.results[index].samples} samples`;
}

// The cells of the table and the points of the chart that are not what metrics.json says.
export async function wrongNumbers(page, metrics) {
  const wrong = [];
  const names = await cells(page, 'name');
  for (const [id, [digits, value]] of Object.entries(COLUMNS)) {
    const shown = await cells(page, id);
    metrics.results.forEach((row, index) => {
      const name = nameOf(index, metrics);
      const right = value(row) === null ? '–' : value(row).toFixed(digits);
      if (shown[names.indexOf(name)] !== right) wrong.push(`${name}: ${id}`);
    });
  }
  const axes = {x: await page.inputValue('#chart-x'), y: await page.inputValue('#chart-y')};
  const points = await page.evaluate(() => plot.chart.data.datasets.flatMap((set) => set.data));
  metrics.results.forEach((row, index) => {
    const point = points.find(({label}) => label === nameOf(index, metrics));
    for (const [axis, drawn] of [['x', point?.cost], ['y', point?.error]]) {
      const right = COLUMNS[axes[axis]][1](row);
      if (drawn !== right) wrong.push(`${nameOf(index, metrics)}: ${axes[axis]} in the chart`);
    }
  });
  return wrong.sort();
}

export const numberTests = {
  async 'has a row for each result'({page, metrics}) {
    assert.equal((await cells(page, 'name')).length, metrics.results.length);
    assert.match(await page.textContent('#shown'), new RegExp(`^${metrics.results.length} `));
  },

  async 'shows the numbers that were measured'({page, metrics, tool, folder}) {
    assert.deepEqual(Object.keys(COLUMNS), await page.evaluate(() => columns.map((c) => c.id)));
    assert.deepEqual(await wrongNumbers(page, metrics), []);
    // By another way, where it is the same: the pictures in the folder, measured by `diff`.
    const measured = (row, by) => JSON.parse(execFileSync(
        tool, ['diff', join(folder, row.image), join(folder, by), '--json'], {encoding: 'utf8'}));
    const rmse = await cells(page, 'rmse'), flip = await cells(page, 'flip');
    const names = await cells(page, 'name');
    metrics.results.forEach((row, index) => {
      const at = names.indexOf(nameOf(index, metrics));
      const again = measured(row, 'truth.exr');
      assert.equal(flip[at], again.flip.toFixed(4));
      if (row.seeds === 1) assert.equal(rmse[at], again.rmse.toFixed(3));
    });
  },

  async 'sorts by a column, both ways, by mouse and by keyboard'({page, metrics}) {
    const rising = metrics.results.map((row) => row.rmse).sort((a, b) => a - b)
        .map((value) => value.toFixed(3));
    await page.click('th[data-column=rmse] button');
    assert.deepEqual(await cells(page, 'rmse'), rising);
    assert.equal(await page.getAttribute('th[data-column=rmse]', 'aria-sort'), 'ascending');
    await page.focus('th[data-column=rmse] button');
    await page.keyboard.press('Enter');
    assert.deepEqual(await cells(page, 'rmse'), rising.reverse());
    assert.equal(await page.getAttribute('th[data-column=rmse]', 'aria-sort'), 'descending');
    assert.equal(await page.getAttribute('th[data-column=psnr]', 'aria-sort'), 'none');
  },

  async 'filters by words'({page}) {
    await page.fill('#filter', 'stoch 4');
    assert.deepEqual(await cells(page, 'name'), ['stochastic:masks=naive, 4 samples']);
    assert.equal(await page.textContent('#shown'), '1 of 12 results');
    const failing = () => page.$$eval('#failures tbody th', (all) => all.map((h) => h.innerText));
    assert.deepEqual(await failing(), ['stochastic:masks=naive, 4 samples']);
    await page.fill('#filter', '');
    assert.equal((await failing()).length, 12);
  },

  // By definition: the least error of the rows that cost no more. Equal is what is shown alike.
  async 'finds the best of each method within a budget'({page, metrics}) {
    for (const [cost, error] of [['bytes_per_pixel', 'rmse'], ['ratio_to_blend', 'rmse_same_s']]) {
      await page.selectOption('#budget-cost', cost);
      await page.selectOption('#budget-error', error);
      const table = await page.$$eval('#budgets tr', (trs) => trs.map((tr) => [...tr.cells].map(
          (cell) => [cell.textContent, cell.classList.contains('best')])));
      const budgets = table[0].slice(1).map(([text]) => Number(text));
      const costs = metrics.results.map((row) => row[cost]);
      assert.ok(budgets[0] >= Math.min(...costs) && budgets.at(-1) >= Math.max(...costs));
      assert.ok(budgets.slice(1).every((budget, i) => budget > budgets[i]));
      assert.deepEqual(table.slice(1).map(([[method]]) => method).sort(),
                       [...new Set(metrics.results.map((row) => row.method))].sort());
      const least = (rows, budget) => Math.min(...rows.filter((row) => row[cost] <= budget)
          .map((row) => row[error]));
      for (const [[method], ...cells] of table.slice(1)) {
        cells.forEach(([text, best], i) => {
          const own = least(metrics.results.filter((row) => row.method === method), budgets[i]);
          assert.equal(text, Number.isFinite(own) ? own.toFixed(3) : '–',
                       `${method} ${budgets[i]}`);
          assert.equal(best, own < Infinity &&
                       own.toFixed(3) === least(metrics.results, budgets[i]).toFixed(3));
        });
      }
      const lines = await page.evaluate(() => budgets.chart.data.datasets.map((set) => set.label));
      assert.deepEqual(lines, table.slice(1).map(([[method]]) => method));
      // In words, the first of the winners: within the least budget.
      const words = await page.textContent('#budget-best');
      assert.match(words, /^◆ Best for /);
      assert.ok(words.includes(`${table[0][1][0]}: `));
    }
  },

  // Two layers in every pixel, of opacity 0.45, at depths 1 and 2: one band of each scale has all.
  async 'shows where the errors are'({page, metrics}) {
    const names = await page.$$eval('#kind option', (all) => all.map((option) => option.value));
    assert.deepEqual(names, metrics.failures.map((scale) => scale.id));
    for (const scale of metrics.failures) {
      await page.selectOption('#kind', scale.id);
      const heads = await page.$$eval('#failures thead th', (all) => all.map((h) => h.innerText));
      const right = {layers: '2', opacity: '0.35 to 0.55', gap: 'above 10 %'}[scale.id];
      const all = scale.bands.findIndex((band) => band.name === right);
      assert.equal(heads[1 + all].replace(/\s+/g, ' '), `${right} 100.0 %`);
      const rows = await page.$$eval('#failures tbody tr', (trs) => trs.map(
          (tr) => [tr.dataset.key, [...tr.cells].slice(1).map((cell) => cell.textContent)]));
      assert.equal(rows.length, metrics.results.length);
      for (const [key, shown] of rows) {
        const row = metrics.results[key];
        assert.deepEqual(shown, scale.bands.map((_, band) => (band === all ?
            row.rmse_same_s.toFixed(3) : '–')));
      }
    }
    const labels = await page.evaluate(() => failures.chart.data.datasets.map((set) => set.label));
    assert.deepEqual(labels, ['A: blend, 1 samples']);
  },

  async 'draws the chart and finds the front'({page, metrics}) {
    await page.selectOption('#chart-x', 'bytes_per_pixel');
    await page.selectOption('#chart-y', 'rmse');
    // By definition: nothing is as good in both and better in one, as it is shown. Of equals one is
    // enough.
    const shown = metrics.results.map(({rmse, bytes_per_pixel}) =>
        ({rmse: Number(rmse.toFixed(3)), bytes_per_pixel}));
    const beats = (a, b) => a.rmse <= b.rmse && a.bytes_per_pixel <= b.bytes_per_pixel &&
        (a.rmse < b.rmse || a.bytes_per_pixel < b.bytes_per_pixel);
    const best = shown.filter((b) => !shown.some((a) => beats(a, b)));
    const values = (rows) => [...new Set(rows.map((r) => `${r.rmse} ${r.bytes_per_pixel}`))].sort();
    const marked = await page.$$eval('#results tr.front', (rows) => rows.map((r) => r.dataset.key));
    assert.deepEqual(values(marked.map((key) => shown[key])), values(best));
    const points = await page.evaluate(() => plot.chart.data.datasets.map((s) => s.data.length));
    assert.equal(points[0] + points[1], metrics.results.length);
    assert.equal(points[1], marked.length);
    const painted = await page.$eval('#chart', (canvas) => {
      const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value) => value !== 0);
    });
    assert.ok(painted);
  },
};
