// The report's pictures: two of them against one another, and the pixels in them.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

import {nameOf} from './report_numbers.mjs';

const codesOf = (linear) => Math.round(255 * (linear <= 0.04045 / 12.92 ? 12.92 * linear :
    1.055 * linear ** (1 / 2.4) - 0.055));

export const viewerTests = {
  async 'shows the pictures that were drawn'({page, metrics, folder}) {
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

  // Two layers are not too many for the method: its function is the exact one, at all depths.
  async 'shows what methods take transmittance for'({page}) {
    const drawn = () => page.evaluate(() => layers.chart.data.datasets.map(
        ({label, data}) => [label, data.map((p) => [p.x, p.y])]));
    const [[exact], [method, points]] = await drawn();
    assert.equal(exact, 'exact');
    assert.equal(method, 'adaptive');
    const right = (x) => (x < 1 ? 1 : x < 2 ? 0.55 : 0.3025);
    const away = points.filter(([x]) => Math.abs(x - 1) > 1e-4 && Math.abs(x - 2) > 1e-4);
    assert.ok(away.length > 50 && away.some(([x]) => x < 1) && away.some(([x]) => x > 2));
    for (const [x, y] of away) assert.ok(Math.abs(y - right(x)) <= 0.0006, `${y} at ${x}`);
    await page.click('#curve-methods input[value=adaptive]');
    assert.equal((await drawn()).length, 1);
    await page.focus('#curve-methods input[value=adaptive]');
    await page.keyboard.press(' ');
    assert.equal((await drawn()).length, 2);
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

  async 'has commands that make the pictures again'({page, scene, tool, folder}) {
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
};
