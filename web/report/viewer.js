// Two pictures over one another, beside one another or in turns, enlarged, with their numbers.
'use strict';

const MODES = [['slider', 'Slider'], ['split', 'Side by side'], ['flicker', 'Flicker']];
const SHOWN = [['picture', 'Pictures'], ['error', 'Error maps']];
const ZOOMS = [0.5, 1, 2, 4, 8, 16, 32];
const FLICKER_MS = 500;

const viewer = {a: 'truth', b: 'truth', mode: 'slider', show: 'picture', zoom: 1, x: 0, y: 0,
                turn: 'a', timer: 0, onChange: () => {}};

// The truth's error is none.
function sourceOf(key) {
  const row = pictureOf(key);
  return viewer.show === 'error' && row.error_map ? row.error_map : row.picture;
}

function captionOf(side) {
  const row = pictureOf(viewer[side]);
  const what = viewer.show === 'error' && row.error_map ? 'error of ' : '';
  return `${side.toUpperCase()}: ${what}${row.label}`;
}

function pictureElement(side, properties = {}) {
  const image = make('img', {src: sourceOf(viewer[side]), alt: captionOf(side), draggable: false,
                             width: Math.round(data.width * viewer.zoom),
                             height: Math.round(data.height * viewer.zoom), ...properties});
  image.dataset.side = side;
  return image;
}

function pane(content) {
  return make('div', {className: 'pane'}, content, make('div', {className: 'marker'}));
}

function sliderPanes() {
  if (!customElements.get('img-comparison-slider')) return splitPanes();
  const slider = make('img-comparison-slider', {'aria-label': 'Divider between A and B'},
                      pictureElement('a', {slot: 'first'}), pictureElement('b', {slot: 'second'}));
  return [pane(slider)];
}

function splitPanes() {
  const scrolls = ['a', 'b'].map((side) => make('div', {className: 'scroll', tabIndex: 0},
                                                pane(pictureElement(side))));
  for (const scroll of scrolls) {
    scroll.addEventListener('scroll', () => {
      for (const other of scrolls) {
        other.scrollLeft = scroll.scrollLeft;
        other.scrollTop = scroll.scrollTop;
      }
    });
  }
  return ['a', 'b'].map((side, i) => make('figure', {}, scrolls[i],
                                          make('figcaption', {}, captionOf(side))));
}

// Both pictures are there from the start, so that neither flashes when it is first shown.
function flickerPanes() {
  const images = ['a', 'b'].map((side) => pictureElement(side));
  const figure = make('figure', {}, pane(make('div', {}, ...images)), make('figcaption', {}));
  return [figure];
}

function showTurn() {
  for (const image of byId('stage').querySelectorAll('img')) {
    image.hidden = image.dataset.side !== viewer.turn;
  }
  byId('stage').querySelector('figcaption').textContent =
      `${captionOf(viewer.turn)} (space: the other one, and stops)`;
}

function takeTurn() {
  viewer.turn = viewer.turn === 'a' ? 'b' : 'a';
  showTurn();
}

function startFlicker() {
  showTurn();
  // Who asked for less motion flips by hand.
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) {
    viewer.timer = setInterval(takeTurn, FLICKER_MS);
  }
}

function drawStage() {
  clearInterval(viewer.timer);
  const panes = {slider: sliderPanes, split: splitPanes, flicker: flickerPanes}[viewer.mode]();
  byId('stage').replaceChildren(make('div', {className: 'panes'}, ...panes));
  if (viewer.mode === 'flicker') startFlicker();
  byId('zoom').textContent = `${viewer.zoom}×`;
  byId('legend').hidden = viewer.show !== 'error';
  byId('pick-a').value = viewer.a;
  byId('pick-b').value = viewer.b;
  moveMarkers();
  drawCommands();
  showPixel();
}

function moveMarkers() {
  for (const marker of byId('stage').querySelectorAll('.marker')) {
    const side = Math.max(viewer.zoom, 3);
    Object.assign(marker.style, {left: `${viewer.x * viewer.zoom}px`,
                                 top: `${viewer.y * viewer.zoom}px`, width: `${side}px`,
                                 height: `${side}px`});
  }
}

// --- the pixel's numbers -----------------------------------------------------------------------

const decoded = new Map();

// The bytes of a picture: RGBA, straight, sRGB.
function bytesOf(key) {
  if (!decoded.has(key)) {
    decoded.set(key, (async () => {
      const image = make('img', {src: pictureOf(key).picture});
      await image.decode();
      const canvas = make('canvas', {width: data.width, height: data.height});
      const context = canvas.getContext('2d', {willReadFrequently: true});
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, data.width, data.height).data;
    })());
  }
  return decoded.get(key);
}

function linearOf(code) {
  const v = code / 255;
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
}

function pixelRow(name, codes, linear) {
  const swatch = make('span', {className: 'swatch'});
  if (codes) swatch.style.background = `rgb(${codes.join(' ')})`;
  return make('tr', {}, make('th', {scope: 'row'}, codes ? swatch : '', ` ${name}`),
              ...(codes || ['', '', '']).map((code) => make('td', {}, String(code))),
              ...linear.map((value) => make('td', {}, value.toFixed(2))));
}

async function showPixel() {
  const asked = `${viewer.a} ${viewer.b} ${viewer.x} ${viewer.y}`;
  viewer.asked = asked;
  byId('pixel-x').value = viewer.x;
  byId('pixel-y').value = viewer.y;
  const at = 4 * (viewer.y * data.width + viewer.x);
  const values = [];
  for (const key of [viewer.a, viewer.b, 'truth']) {
    const codes = [...(await bytesOf(key)).slice(at, at + 3)];
    values.push({codes, linear: codes.map((code) => 255 * linearOf(code))});
  }
  if (viewer.asked !== asked) return;
  const [a, b] = values;
  const difference = a.linear.map((value, c) => value - b.linear[c]);
  byId('pixel').tBodies[0].replaceChildren(
      pixelRow(captionOfPixel('a'), a.codes, a.linear),
      pixelRow(captionOfPixel('b'), b.codes, b.linear), pixelRow('A − B', null, difference),
      pixelRow('the truth', values[2].codes, values[2].linear));
}

const captionOfPixel = (side) => `${side.toUpperCase()}: ${pictureOf(viewer[side]).label}`;

function choosePixel(x, y) {
  if (!Number.isFinite(x) || !Number.isFinite(y)) return;
  viewer.x = Math.min(Math.max(Math.floor(x), 0), data.width - 1);
  viewer.y = Math.min(Math.max(Math.floor(y), 0), data.height - 1);
  moveMarkers();
  showPixel();
  drawLayers();
}

function choosePixelAt(event) {
  const image = event.target.closest('.pane')?.querySelector('img:not([hidden])');
  if (!image) return;
  const box = image.getBoundingClientRect();
  choosePixel((event.clientX - box.left) / box.width * data.width,
              (event.clientY - box.top) / box.height * data.height);
}
