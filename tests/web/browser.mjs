// Chromium for the tests of pages, and what a page may not do.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';

const SKIPPED = 77;

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(SKIPPED);
}

export function loadPlaywright() {
  const folder = new URL('../../web/package.json', import.meta.url);
  try {
    return createRequire(folder)('playwright-core');
  } catch {
    return skip("there is no playwright-core; 'npm ci' in web/ brings it");
  }
}

export function findChromium() {
  const asked = process.env.CHROMIUM;
  const places = asked ? [asked] : ['/usr/bin/chromium', '/usr/bin/chromium-browser'];
  return places.find((path) => existsSync(path)) ||
      skip('there is no Chromium; install the package chromium, or set CHROMIUM to its path');
}

// What is printed in the page's console, fails, or asks for the network.
export function watch(page, faults) {
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks for ${request.url()}`);
  });
}
