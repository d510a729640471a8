// The report as a file: with wrong numbers, on a phone, without libraries, of scenes whose names
// look like HTML.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {cpSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

import {COLUMNS, cells, nameOf, wrongNumbers} from './report_numbers.mjs';

export const fileTests = {
  // What the test of numbers is worth: each column is wrong in one row of this page, and it names
  // those cells and no others.
  async 'is not taken for right with wrong numbers'({page, metrics, folder}) {
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

  async 'takes no name for markup'({page, tool, folder}) {
    mkdirSync(join(folder, '<'));
    const scene = join(folder, '<', 'script><img src=x onerror=alert(1)>&.obj');
    writeFileSync(scene, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
    execFileSync(tool, ['compare', scene, '--size', '8x8', '--samples', '1', '--methods', 'blend',
                        '-o', join(folder, 'markup')]);
    await page.goto(pathToFileURL(join(folder, 'markup', 'report.html')).href);
    assert.equal(await page.textContent('#scene'), scene);
  },

  // As built where npm's packages could not be had.
  async 'does without libraries'({page, metrics, folder}) {
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

  async 'fits a phone'({page, folder}) {
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
