// The report of `sheer compare`, made by the tool and opened from disk in headless Chromium with
// the network off: what a person does with it, by mouse, by keyboard and on a phone.
//
//   node report_test.mjs TOOL [FOLDER FOR PICTURES OF THE PAGE]
//
// Exit code 77, after a line that says why, where there is no Chromium or no playwright-core.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

import {findChromium, loadPlaywright, watch} from './browser.mjs';
import {fileTests} from './report_files.mjs';
import {METHODS, numberTests} from './report_numbers.mjs';
import {viewerTests} from './report_viewer.mjs';

const SCENE = 'builtin:layers?order=far-to-near&background=0,0,1';

const tool = process.argv[2];
const pictures = process.argv[3];
const {chromium} = loadPlaywright();
const executablePath = findChromium();
const folder = mkdtempSync(join(tmpdir(), 'sheer-report-'));

function makeReport() {
  const scene = `${SCENE}&alpha=0.45,0.45&color=1,0,0;0,1,0&depth=1,2`;
  execFileSync(tool, ['compare', scene, '--size', '48x32', '--samples', '1,4', '--seeds', '3',
                      '--methods', METHODS, '-o', folder]);
  return {tool, folder, scene,
          metrics: JSON.parse(readFileSync(join(folder, 'metrics.json'), 'utf8'))};
}

// Each on the report as the one before left it.
const tests = {...numberTests, ...viewerTests, ...fileTests};

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
