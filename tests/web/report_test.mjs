// The report of `sheer compare`, made by the tool and opened from disk in headless Chromium with
// the network off: what a person does with it, by mouse, by keyboard and on a phone.
//
//   node report_test.mjs TOOL [FOLDER FOR PICTURES OF THE PAGE]
//
// Exit code 77, after a line that says why, where there is no Chromium or no playwright-core.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from
    'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const SKIPPED = 77;
const METHODS = 'blend,exact,stochastic:masks=naive,wboit,weighted-average';
const SCENE = 'builtin:layers?order=far-to-near&background=0,0,1';

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(SKIPPED);
}

function loadPlaywright() {
  const folder = new URL('../../web/package.json', import.meta.url);
  try {
    return createRequire(folder)('playwright-core');
  } catch {
    return skip("there is no playwright-core; 'npm ci' in web/ brings it");
  }
}

function findChromium() {
  const asked = process.env.CHROMIUM;
  const places = asked ? [asked] : ['/usr/bin/chromium', '/usr/bin/chromium-browser'];
  return places.find((path) => existsSync(path)) ||
      skip('there is no Chromium; install the package chromium, or set CHROMIUM to its path');
}

const tool = process.argv[2];
const pictures = process.argv[3];
const {chromium} = loadPlaywright();
const executablePath = findChromium();
const folder = mkdtempSync(join(tmpdir(), 'sheer-report-'));

function makeReport() {
  const scene = `${SCENE}&alpha=0.45,0.45&color=1,0,0;0,1,0&depth=1,2`;
  execFileSync(tool, ['compare', scene, '--size', '48x32', '--samples', '1,4', '--seeds', '3',
                      '--methods', METHODS, '-o', folder]);
  return {scene, metrics: JSON.parse(readFileSync(join(folder, 'metrics.json'), 'utf8'))};
}

// What is printed in the page's console, fails, or asks for the network.
function watch(page, faults) {
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks for ${request.url()}`);
  });
}

const column = (page, id) => page.$$eval(
    '#results thead th', (heads, want) => heads.findIndex((h) => h.dataset.column === want), id);

async function cells(page, id) {
  const index = await column(page, id);
  return page.$$eval('#results tbody tr', (rows, i) => rows.map((row) => row.cells[i].textContent),
                     index);
}

const codesOf = (linear) => Math.round(255 * (linear <= 0.04045 / 12.92 ? 12.92 * linear :
    1.055 * linear ** (1 / 2.4) - 0.055));

// The columns, each with what metrics.json has for it, in the digits of the page.
const COLUMNS = {
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
function nameOf(index, metrics) {
  const methods = METHODS.split(',');
  return `${methods[index % methods.length]}, ${metrics.results[index].samples} samples`;
}

// The cells of the table and the points of the chart that are not what metrics.json says.
async function wrongNumbers(page, metrics) {
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

const tests = {
  async 'has a row for each result'({page, metrics}) {
    assert.equal((await cells(page, 'name')).length, metrics.results.length);
    assert.match(await page.textContent('#shown'), new RegExp(`^${metrics.results.length} `));
  },

  async 'shows the numbers that were measured'({page, metrics}) {
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

  async 'shows the pictures that were drawn'({page, metrics}) {
    await page.click('#mode input[value=split]');
    const file = (name) => 'data:image/png;base64,' + readFileSync(join(folder, name), 'base64');
    for (const [index, row] of metrics.results.entries()) {
      await page.selectOption('#pick-a', {label: nameOf(index, metrics)});
      await page.click('#show input[value=picture]');
      const source = () => page.$eval('#stage img', (image) => image.src);
      assert.equal(await source(), file(row.image.replace('.exr', '.png')));
      await page.click('#show input[value=error]');
      assert.equal(await source(), file(row.error_map));
    }
    await page.click('#show input[value=picture]');
    await page.click('#mode input[value=slider]');
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
    assert.equal(await page.textContent('#shown'), '1 of 10 results');
    await page.fill('#filter', '');
  },

  async 'draws the chart and finds the front'({page, metrics}) {
    await page.selectOption('#chart-x', 'bytes_per_pixel');
    await page.selectOption('#chart-y', 'rmse');
    // By definition: nothing is as good in both and better in one. Of equals one is enough.
    const beats = (a, b) => a.rmse <= b.rmse && a.bytes_per_pixel <= b.bytes_per_pixel &&
        (a.rmse < b.rmse || a.bytes_per_pixel < b.bytes_per_pixel);
    const best = metrics.results.filter((b) => !metrics.results.some((a) => beats(a, b)));
    const values = (rows) => [...new Set(rows.map((r) => `${r.rmse} ${r.bytes_per_pixel}`))].sort();
    const marked = await page.$$eval('#results tr.front', (rows) => rows.map((r) => r.dataset.key));
    assert.deepEqual(values(marked.map((key) => metrics.results[key])), values(best));
    const points = await page.evaluate(() => plot.chart.data.datasets.map((s) => s.data.length));
    assert.equal(points[0] + points[1], metrics.results.length);
    assert.equal(points[1], marked.length);
    const painted = await page.$eval('#chart', (canvas) => {
      const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.some((value) => value !== 0);
    });
    assert.ok(painted);
  },

  async 'slides between two pictures by mouse and by keyboard'({page}) {
    await page.selectOption('#pick-a', {label: 'blend, 4 samples'});
    await page.selectOption('#pick-b', {label: 'wboit, 4 samples'});
    await page.click('#zoom-in');
    await page.click('#zoom-in');
    assert.equal(await page.textContent('#zoom'), '4×');
    const slider = page.locator('img-comparison-slider');
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox();
    assert.ok(Math.abs(box.width - 4 * 48) < 1 && Math.abs(box.height - 4 * 32) < 1);
    const value = () => slider.evaluate((element) => element.exposure ?? element.value);
    const before = await value();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.2, box.y + box.height / 2, {steps: 5});
    await page.mouse.up();
    await page.waitForFunction(
        (old) => document.querySelector('img-comparison-slider').value !== old, before);
    const dragged = await value();
    assert.ok(Math.abs(dragged - 20) < 3, `${dragged} is not about 20`);
    await slider.focus();
    await page.keyboard.down('ArrowRight');
    await page.waitForFunction(
        (old) => document.querySelector('img-comparison-slider').value > old, dragged);
    await page.keyboard.up('ArrowRight');
  },

  // Blended front to back by hand: 0.45 red over 0.45 green over blue.
  async 'tells the numbers of a pixel'({page}) {
    await page.selectOption('#pick-b', {label: 'exact, 4 samples'});
    await page.fill('#pixel-x', '7');
    await page.fill('#pixel-y', '5');
    const codes = [0.45, 0.55 * 0.45, 0.55 * 0.55].map(codesOf);
    await page.waitForFunction(() => document.querySelectorAll('#pixel tbody tr').length === 4);
    const row = async (i) => (await page.$$eval(
        `#pixel tbody tr:nth-child(${i}) td`, (tds) => tds.map((td) => td.textContent)));
    await page.waitForFunction(
        (text) => document.querySelector('#pixel tbody tr:nth-child(2)').textContent.includes(text),
        codes.join(''));
    assert.deepEqual((await row(2)).slice(0, 3), codes.map(String));
    assert.deepEqual((await row(4)).slice(0, 3), codes.map(String));  // the truth
    const linear = (await row(2)).slice(3).map(Number);
    // Half a code of 255 is at most 0.5 * 2.275 / 255 linear, where the curve is steepest.
    [0.45, 0.2475, 0.3025].forEach((v, c) => assert.ok(Math.abs(linear[c] - 255 * v) < 1.2));
  },

  async 'shows the pixel that is clicked'({page}) {
    await page.click('#mode input[value=split]');
    const image = page.locator('#stage img').first();
    await image.scrollIntoViewIfNeeded();
    await image.click({position: {x: 4 * 20 + 2, y: 4 * 9 + 1}});
    assert.equal(await page.inputValue('#pixel-x'), '20');
    assert.equal(await page.inputValue('#pixel-y'), '9');
  },

  // Two layers of opacity 0.45 everywhere, at depths 1 and 2.
  async 'shows the layers of a pixel'({page}) {
    const title = await page.textContent('#probe-title');
    assert.match(title, /: 2 transparent fragments let 30\.[23] %/);
    const rows = await page.$$eval('#layers tbody tr', (all) => all.map(
        (tr) => [...tr.cells].slice(1).map((cell) => Number(cell.textContent))));
    assert.deepEqual(rows, [[1, 0.45, 1, 0.55], [2, 0.45, 1, 0.3025]]);
    const steps = await page.evaluate(() => layers.chart.data.datasets[0].data.map((p) => p.y));
    assert.deepEqual(steps, [1, 0.55, 0.3025, 0.3025]);
  },

  async 'flips between two pictures'({page}) {
    await page.click('#mode input[value=flicker]');
    const shown = () => page.$eval('#stage img:not([hidden])', (image) => image.dataset.side);
    const first = await shown();
    await page.waitForFunction(
        (side) => document.querySelector('#stage img:not([hidden])').dataset.side !== side, first);
    await page.focus('#stage');
    await page.keyboard.press(' ');  // stops
    const stopped = await shown();
    await page.waitForTimeout(700);
    assert.equal(await shown(), stopped);
    await page.keyboard.press(' ');
    assert.notEqual(await shown(), stopped);
  },

  async 'shows error maps with their scale'({page}) {
    await page.click('#mode input[value=split]');
    await page.click('#show input[value=error]');
    assert.ok(await page.isVisible('#legend'));
    const scale = await page.evaluate(() => data.error_map_scale);
    assert.ok((await page.textContent('#legend-most')).startsWith(`${scale} or more`));
    const sources = await page.$$eval('#stage img', (images) => images.map((i) => i.src));
    const expected = await page.evaluate(
        () => [viewer.a, viewer.b].map((key) => data.results[key].error_map));
    assert.deepEqual(sources, expected);
    await page.click('#show input[value=picture]');
  },

  async 'has commands that make the pictures again'({page, scene}) {
    await page.selectOption('#pick-a', {label: 'stochastic:masks=naive, 4 samples'});
    const commands = await page.$$eval('#commands code', (all) => all.map((c) => c.textContent));
    assert.equal(commands[0], `sheer render '${scene}' --size 48x32 --method ` +
        'stochastic:masks=naive --samples 4 -o stochastic-masks=naive.s4.png');
    const [, ...words] = commands[0].replaceAll("'", '').split(' ');
    words[words.length - 1] = join(folder, 'again.png');
    execFileSync(tool, words);
    assert.deepEqual(readFileSync(join(folder, 'again.png')),
                     readFileSync(join(folder, 'stochastic-masks=naive.s4.png')));
  },

  // What the test of numbers is worth: each column is wrong in one row of this page, and it names
  // those cells and no others.
  async 'is not taken for right with wrong numbers'({page, metrics}) {
    const whole = readFileSync(join(folder, 'report.html'), 'utf8');
    const [before, json, after] = whole.split(/(?<=id="data">)(.*?)(?=<\/script>)/s);
    const data = JSON.parse(json), expected = [];
    Object.keys(COLUMNS).forEach((id, i) => {
      const index = (3 * i + 2) % data.results.length, row = data.results[index];
      if (id === 'ms') row.ms.total += 1;
      else if (id === 'peak_memory') row.peak_memory_bytes += 2 ** 20;
      else if (id !== 'samples') row[id] = (row[id] ?? 0) + 1;
      if (id === 'samples') return;  // part of the names by which rows are found
      expected.push(`${nameOf(index, metrics)}: ${id}`);
      if (id === 'rmse_same_s' || id === 'ratio_to_blend') {
        expected.push(`${nameOf(index, metrics)}: ${id} in the chart`);
      }
    });
    writeFileSync(join(folder, 'wrong.html'),
                  before + JSON.stringify(data).replaceAll('<', '\\u003c') + after);
    await page.goto(pathToFileURL(join(folder, 'wrong.html')).href);
    assert.deepEqual(await wrongNumbers(page, metrics), expected.sort());
  },

  async 'takes no name for markup'({page}) {
    mkdirSync(join(folder, '<'));
    const scene = join(folder, '<', 'script><img src=x onerror=alert(1)>&.obj');
    writeFileSync(scene, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
    execFileSync(tool, ['compare', scene, '--size', '8x8', '--samples', '1', '--methods', 'blend',
                        '-o', join(folder, 'markup')]);
    await page.goto(pathToFileURL(join(folder, 'markup', 'report.html')).href);
    assert.equal(await page.textContent('#scene'), scene);
  },

  // As built where npm's packages could not be had.
  async 'does without libraries'({page, metrics}) {
    const web = join(folder, 'web');
    cpSync(new URL('../../web/report', import.meta.url), join(web, 'report'), {recursive: true});
    const script = new URL('../../cmake/report_page.cmake', import.meta.url).pathname;
    execFileSync('cmake', ['-D', `WEB=${web}`, '-D', `TO=${join(folder, 'page')}`, '-P', script]);
    const whole = readFileSync(join(folder, 'report.html'), 'utf8');
    const json = whole.match(/id="data">(.*?)<\/script>/s)[1];
    const bare = readFileSync(join(folder, 'page.html'), 'utf8').replace('@DATA@', () => json);
    writeFileSync(join(folder, 'bare.html'), bare);
    await page.goto(pathToFileURL(join(folder, 'bare.html')).href);
    assert.equal((await cells(page, 'name')).length, metrics.results.length);
    assert.ok(!(await page.isVisible('#chart')));
    assert.match(await page.textContent('#front'), /^◆/);
    assert.equal(await page.locator('#stage img').count(), 2);
  },

  async 'fits a phone'({page}) {
    await page.setViewportSize({width: 390, height: 844});
    await page.goto(pathToFileURL(join(folder, 'report.html')).href);
    for (const mode of ['slider', 'split', 'flicker']) {
      await page.click(`#mode input[value=${mode}]`);
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= 390, `${width} pixels wide by ${mode}`);
    }
    await page.click('#mode input[value=slider]');
  },
};

let failed = 0;
const browser = await chromium.launch({executablePath, args: ['--no-sandbox']});
try {
  const made = makeReport();
  const context = await browser.newContext({viewport: {width: 1200, height: 900}});
  await context.setOffline(true);
  context.setDefaultTimeout(60000);
  const page = await context.newPage();
  const faults = [];
  watch(page, faults);
  await page.goto(pathToFileURL(join(folder, 'report.html')).href);
  for (const [name, test] of Object.entries(tests)) {
    try {
      await test({page, ...made});
      assert.deepEqual(faults, []);
      console.log(`ok: the report ${name}`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED: the report ${name}\n${error.stack}`);
    }
    faults.length = 0;
    if (pictures) {
      const file = `${name.replaceAll(/\W+/g, '-')}.png`;
      await page.screenshot({path: join(pictures, file), fullPage: true});
    }
  }
} finally {
  await browser.close();
  rmSync(folder, {recursive: true});
}
console.log(`${Object.keys(tests).length - failed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
