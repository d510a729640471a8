// What the report knows: the data that the tool put into the page, and names for it.
'use strict';

const data = JSON.parse(document.getElementById('data').textContent);

const byId = (id) => document.getElementById(id);

// An element with properties, attributes where a name has a dash, and children.
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes('-') || name === 'role' || name === 'scope' || name === 'slot') {
      element.setAttribute(name, value);
    } else {
      element[name] = value;
    }
  }
  element.append(...children);
  return element;
}

const oneSampleCount = new Set(data.results.map((row) => row.samples)).size === 1;
data.results.forEach((row, index) => {
  row.key = String(index);
  row.label = oneSampleCount ? row.name : `${row.name}, ${row.samples} samples`;
});
const truth = {key: 'truth', label: 'the truth', picture: data.truth.picture,
               command: data.truth.command};
const everyPicture = [truth, ...data.results];
const pictureOf = (key) => everyPicture.find((row) => row.key === key) || truth;

// Numbers of the table. Of `error` and `cost` the chart has axes.
const MIB = 1024 * 1024;
const columns = [
  {id: 'samples', title: 'S', value: (r) => r.samples, digits: 0,
   meaning: 'Samples of a pixel.'},
  {id: 'rmse', title: 'rmse', value: (r) => r.rmse, digits: 3, error: true,
   meaning: 'Root mean square of the difference from the truth, in linear colour times 255; ' +
            'of random methods over all seeds.'},
  {id: 'rmse_same_s', title: 'rmse same S', value: (r) => r.rmse_same_s, digits: 3, error: true,
   meaning: 'The same against the exact answer at the method\'s own samples, so that jagged ' +
            'edges do not count as a fault of the method.'},
  {id: 'psnr', title: 'psnr', value: (r) => r.psnr, digits: 2,
   meaning: '20 log10(255 / rmse), in decibels.'},
  {id: 'ssim', title: 'ssim', value: (r) => r.ssim, digits: 4,
   meaning: 'How alike structures are, 1 at the most (Wang and others 2004), of sRGB encoded ' +
            'pictures.'},
  {id: 'flip', title: 'flip', value: (r) => r.flip, digits: 4, error: true,
   meaning: 'What someone sees who flips between the picture and the truth, from 0 to 1 ' +
            '(LDR-FLIP, Andersson and others 2020).'},
  {id: 'bias', title: 'bias', value: (r) => r.bias, digits: 3, error: true,
   meaning: 'The part of rmse same S that more seeds would not average out.'},
  {id: 'noise', title: 'noise', value: (r) => r.noise, digits: 3, error: true,
   meaning: 'Standard deviation over the seeds.'},
  {id: 'ratio_to_blend', title: '× blend', value: (r) => r.ratio_to_blend, digits: 2, cost: true,
   meaning: 'Time of a frame over that of the method blend.'},
  {id: 'ms', title: 'ms', value: (r) => r.ms.total, digits: 1, cost: true,
   meaning: 'Time of a frame in milliseconds, as it happened to be; ' +
            'sheer bench measures times better.'},
  {id: 'bytes_per_pixel', title: 'bytes/pixel', value: (r) => r.bytes_per_pixel, digits: 0,
   cost: true, meaning: 'What the method stores for a pixel.'},
  {id: 'peak_memory', title: 'peak MiB', value: (r) => r.peak_memory_bytes / MIB, digits: 1,
   meaning: 'The most memory that the process took; all methods are drawn together.'},
];
if (data.results.some((row) => row.rmse_frames !== null)) {
  columns.push(
    {id: 'rmse_frames', title: 'rmse frames', value: (r) => r.rmse_frames, digits: 3, error: true,
     meaning: 'Root mean square of the difference from the truth over all frames, of what is ' +
              'shown.'},
    {id: 'flicker', title: 'flicker', value: (r) => r.flicker, digits: 3, error: true,
     meaning: 'Root mean square of the change from frame to frame beyond that of the truth.'},
    {id: 'ghosting', title: 'ghosting', value: (r) => r.ghosting, digits: 3, error: true,
     meaning: 'Root mean square of that part of the error which earlier frames of the truth ' +
              'explain.'});
}
const columnOf = (id) => columns.find((column) => column.id === id);
const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
const numberText = (value, digits) => (isNumber(value) ? value.toFixed(digits) : '–');

// Rounded as it is shown: an error that is less by less than can be seen is no better.
const shownValue = (column, row) => Number(numberText(column.value(row), column.digits));

// Those that no other beats in both: by rising cost, each with less error than all before it.
function paretoFront(rows, cost, error) {
  const known = rows.filter((row) => isNumber(cost.value(row)) && isNumber(error.value(row)));
  const of = (row) => shownValue(error, row);
  known.sort((a, b) => cost.value(a) - cost.value(b) || of(a) - of(b));
  const front = [];
  for (const row of known) {
    if (front.length === 0 || of(row) < of(front.at(-1))) front.push(row);
  }
  return front;
}
