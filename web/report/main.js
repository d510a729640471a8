// Puts the parts together.
'use strict';

function commandLine(title, command) {
  const button = make('button', {type: 'button', 'aria-label': `Copy the command for ${title}`},
                      'Copy');
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(command);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(button.previousElementSibling);
      button.textContent = 'Selected';
    }
  });
  return [make('div', {}, title),
          make('div', {className: 'command'}, make('code', {}, command), button)];
}

function drawCommands() {
  const shown = [...new Set([viewer.a, viewer.b])].map(pictureOf);
  byId('commands').replaceChildren(
      ...shown.flatMap((row) => commandLine(row.label, row.command)),
      ...commandLine('this page', data.command));
}

function addRadios(id, choices, key) {
  for (const [value, title] of choices) {
    const radio = make('input', {type: 'radio', name: id, value, checked: viewer[key] === value});
    radio.addEventListener('change', () => {
      viewer[key] = value;
      drawStage();
    });
    byId(id).append(make('label', {}, radio, ` ${title}`));
  }
}

function pick(side, key) {
  viewer[side] = key;
  drawStage();
  markRows();
  drawFailureLines();
}

function stepZoom(step) {
  const index = ZOOMS.indexOf(viewer.zoom) + step;
  if (index < 0 || index >= ZOOMS.length) return;
  const stage = byId('stage');
  const factor = ZOOMS[index] / viewer.zoom;
  const middle = {x: stage.scrollLeft + stage.clientWidth / 2,
                  y: stage.scrollTop + stage.clientHeight / 2};
  viewer.zoom = ZOOMS[index];
  drawStage();
  stage.scrollLeft = middle.x * factor - stage.clientWidth / 2;
  stage.scrollTop = middle.y * factor - stage.clientHeight / 2;
}

function handleStageKey(event) {
  if (event.key === '+' || event.key === '=') stepZoom(1);
  else if (event.key === '-') stepZoom(-1);
  else if (event.key === ' ' && viewer.mode === 'flicker') {
    clearInterval(viewer.timer);
    takeTurn();
  } else return;
  event.preventDefault();
}

function drawLegend() {
  const stops = data.colors.map((color) => `rgb(${color.join(' ')})`);
  byId('legend-colors').style.background = `linear-gradient(to right, ${stops.join(', ')})`;
  byId('legend-colors').setAttribute('aria-label', 'black by violet and orange to yellow');
  byId('legend-most').textContent =
      `${data.error_map_scale} or more: root mean square of a pixel's channels, linear × 255`;
}

function startViewer() {
  for (const side of ['a', 'b']) {
    const select = byId(`pick-${side}`);
    for (const row of everyPicture) select.append(make('option', {value: row.key}, row.label));
    select.addEventListener('change', () => pick(side, select.value));
  }
  byId('swap').addEventListener('click', () => {
    [viewer.a, viewer.b] = [viewer.b, viewer.a];
    pick('a', viewer.a);
  });
  addRadios('mode', MODES, 'mode');
  addRadios('show', SHOWN, 'show');
  byId('zoom-in').addEventListener('click', () => stepZoom(1));
  byId('zoom-out').addEventListener('click', () => stepZoom(-1));
  byId('stage').addEventListener('keydown', handleStageKey);
  byId('stage').addEventListener('click', choosePixelAt);
  byId('pixel-x').max = data.width - 1;
  byId('pixel-y').max = data.height - 1;
  for (const id of ['pixel-x', 'pixel-y']) {
    byId(id).addEventListener(
        'input', () => choosePixel(byId('pixel-x').valueAsNumber, byId('pixel-y').valueAsNumber));
  }
  const heads = ['', 'R', 'G', 'B', 'R', 'G', 'B'].map((h) => make('th', {scope: 'col'}, h));
  byId('pixel').tHead.append(
      make('tr', {}, make('td'), make('th', {colSpan: 3, scope: 'colgroup'}, 'sRGB, 8 bits'),
           make('th', {colSpan: 3, scope: 'colgroup'}, 'linear × 255, of these')),
      make('tr', {}, ...heads));
  drawLegend();
}

byId('scene').textContent = data.scene;
byId('tool').textContent = data.tool;
byId('summary').textContent =
    `${data.width}×${data.height} pixels, against the exact answer at ${data.truth.samples} ` +
    `samples a pixel.`;
viewer.x = Math.floor(data.width / 2);
viewer.y = Math.floor(data.height / 2);
// Blend, or else the first, against the truth.
viewer.a = (data.results.find((row) => row.method === 'blend') || data.results[0]).key;
startPlot(pick);
startBudgets();
startViewer();
startTable(pick);
startLayers();
startFailures();
drawStage();
markRows();
