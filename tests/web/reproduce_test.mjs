// The page of `sheer reproduce`, opened from disk in headless Chromium with the network off.
//
//   node reproduce_test.mjs TOOL [FOLDER FOR PICTURES OF THE PAGE]
//
// Exit code 77, after a line that says why, where there is no Chromium or no playwright-core.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, renameSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

import {findChromium, loadPlaywright, watch} from './browser.mjs';

const ENTRIES = ['stratified-figure-5', 'stochastic-examples', 'stochastic-figure-2', 'moment-gap'];

const [, , tool, pictures] = process.argv;
const {chromium} = loadPlaywright();
const executablePath = findChromium();
const folder = mkdtempSync(join(tmpdir(), 'sheer-reproduce-'));
const browser = await chromium.launch({executablePath, args: ['--no-sandbox']});
try {
  const made = join(folder, 'made'), moved = join(folder, 'index.html');
  execFileSync(tool, ['reproduce', ...ENTRIES, '--quick', '-o', made]);
  renameSync(join(made, 'index.html'), moved);  // away from all that it was made of
  rmSync(made, {recursive: true});
  const context = await browser.newContext({viewport: {width: 1200, height: 900}});
  await context.setOffline(true);
  const page = await context.newPage();
  const faults = [];
  watch(page, faults);
  await page.goto(pathToFileURL(moved).href);
  // Every entry, by its link.
  for (const entry of ENTRIES) {
    await page.click(`nav a[href="#${entry}"]`);
    assert.ok(await page.isVisible(`#${entry} h2`));
  }
  const images = await page.$$eval('img', (all) => all.map((i) => [i.complete, i.naturalWidth]));
  assert.ok(images.length >= 2);
  for (const [complete, width] of images) assert.ok(complete && width > 0);
  // What does not agree stays, with a reason, and is counted.
  const rows = await page.$$eval('td.yes, td.no', (cells) => cells.filter((c) =>
    ['yes', 'no'].includes(c.textContent)).map((c) => [c.textContent, c.nextSibling.textContent]));
  const agree = rows.filter(([word]) => word === 'yes').length;
  assert.ok(agree > 0 && agree < rows.length);
  for (const [word, why] of rows) assert.equal(why !== '', word === 'no', why);
  assert.match(await page.textContent('header'), new RegExp(`${agree} of ${rows.length} printed`));
  if (pictures) await page.screenshot({path: join(pictures, 'reproduce.png'), fullPage: true});
  await page.setViewportSize({width: 390, height: 844});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  if (pictures) await page.screenshot({path: join(pictures, 'reproduce-phone.png')});
  assert.deepEqual(faults, []);
  console.log('ok: the page of all entries');
} finally {
  await browser.close();
  rmSync(folder, {recursive: true});
}
