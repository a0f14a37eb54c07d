'use strict';
// Sorts and filters the table, and plots what is left of it. The table's cells are the only data.
const columns = JSON.parse(document.getElementById('columns').textContent);
const table = document.getElementById('records');
const body = table.tBodies[0];
const heads = [...table.tHead.rows[0].cells];
const at = (key) => columns.findIndex((column) => column.key === key);
const value = (row, place) => {
  const cell = row.cells[place];
  return cell.dataset.value === undefined ? cell.textContent : Number(cell.dataset.value);
};

heads.forEach((head, place) => head.firstChild.addEventListener('click', () => {
  const order = head.getAttribute('aria-sort') === 'ascending' ? 'descending' : 'ascending';
  heads.forEach((other) => other.removeAttribute('aria-sort'));
  head.setAttribute('aria-sort', order);
  const sign = order === 'ascending' ? 1 : -1;
  // Rows without the figure come last, whatever the order.
  body.append(...[...body.rows].sort((first, second) => {
    const [a, b] = [value(first, place), value(second, place)];
    if (a === '' || b === '') return (a === '') - (b === '');
    return sign * (typeof a === 'number' ? a - b : a.localeCompare(b));
  }));
}));

const filter = document.getElementById('filter');
const count = document.getElementById('count');
const filtered = () => {
  const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const row of body.rows) {
    const cells = [...row.cells].map((cell) => cell.textContent.toLowerCase());
    row.hidden = !words.every((word) => cells.some((cell) => cell.includes(word)));
    shown += !row.hidden;
  }
  count.textContent = `${shown} of ${body.rows.length} rows`;
};
filter.addEventListener('input', filtered);
filtered();

// A group of rows is what can be compared: the same rays, or pictures of the same scene.
const groupOf = (row) => ['kind', 'map_size', 'scale_m', 'angle_deg', 'backend', 'sampling']
  .map((key) => [columns[at(key)].title, row.cells[at(key)].textContent])
  .filter(([, text]) => text !== '')
  .map(([title, text]) => (/^[a-z]+$/.test(text) ? text : `${title} ${text}`)).join(', ');
const groups = [...new Set([...body.rows].map(groupOf))];
const [rows, across, up] = ['rows', 'across', 'up'].map((id) => document.getElementById(id));
const offer = (select, names, chosen) => names.forEach(([key, title]) => {
  select.add(new Option(title, key, key === chosen, key === chosen));
});
const named = (keys) => keys.map((key) => [key, columns[at(key)].title]);
const ofRays = groups.filter((group) => group.startsWith('rays'));
offer(rows, groups.map((group) => [group, group]), ofRays.length ? ofRays[ofRays.length - 1] : groups[0]);
offer(across, named(['reads', 'p99_reads', 'wave_reads', 'turns', 'bytes', 'displacement_ms', 'frame_ms',
  'map_bytes', 'bake_seconds']), 'reads');
offer(up, named(['p99_texels', 'median_texels', 'mean_texels', 'passed', 'flip', 'ssim', 'psnr_db', 'rms',
  'flicker_rms', 'flicker_flip']), 'p99_texels');

const HIGHER_IS_BETTER = ['ssim', 'psnr_db'];
const svg = document.getElementById('plot');
const WIDTH = 900;
const HEIGHT = 420;
const MARGIN = 60;
const draw = (name, attributes, text) => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  Object.entries(attributes).forEach(([key, number]) => element.setAttribute(key, number));
  if (text !== undefined) element.textContent = text;
  svg.append(element);
};
// A scale of logarithms, with 0 a step before the least number.
const scale = (numbers, from, to) => {
  const positive = numbers.filter((number) => number > 0);
  const [least, most] = [Math.min(...positive, 1), Math.max(...positive, 1)].map(Math.log10);
  const low = Math.floor(least) - 1;
  const high = Math.max(Math.ceil(most), low + 2);
  const place = (exponent) => from + (to - from) * (exponent - low) / (high - low);
  const ticks = [];
  for (let exponent = low; exponent <= high; exponent += 1) {
    ticks.push([place(exponent), exponent === low ? '0' : String(Number((10 ** exponent).toPrecision(1)))]);
  }
  return { ticks, place: (number) => (number > 0 ? place(Math.log10(number)) : from) };
};
const plotted = () => {
  // NaN where a row has no such figure.
  const figure = (row, key) => {
    const place = at(key);
    return row.cells[place].textContent === '' ? NaN : value(row, place) * columns[place].factor;
  };
  const points = [...body.rows].filter((row) => groupOf(row) === rows.value).map((row) => {
    const steps = row.cells[at('steps')].textContent;
    return {
      name: row.cells[at('method')].textContent + (steps ? ` (${steps})` : ''),
      x: figure(row, across.value),
      y: figure(row, up.value),
      // Of medians that have them, what the true ones lie between.
      sure: ['low', 'high'].map((end) => at(across.value.replace('_ms', `_${end}_ms`)))
        .filter((place) => place >= 0 && place !== at(across.value))
        .map((place) => value(row, place) * columns[place].factor),
    };
  }).filter((point) => Number.isFinite(point.x) && Number.isFinite(point.y));
  svg.replaceChildren();
  const frontier = document.getElementById('frontier');
  frontier.textContent = points.length ? '' : 'These rows have no such figures.';
  if (!points.length) return;
  const x = scale(points.map((point) => point.x), MARGIN, WIDTH - MARGIN);
  const y = scale(points.map((point) => point.y), HEIGHT - MARGIN, MARGIN / 2);
  for (const [place, label] of x.ticks) {
    draw('line', { x1: place, x2: place, y1: MARGIN / 2, y2: HEIGHT - MARGIN, stroke: '#ddd' });
    draw('text', { x: place, y: HEIGHT - MARGIN + 18, 'text-anchor': 'middle' }, label);
  }
  for (const [place, label] of y.ticks) {
    draw('line', { x1: MARGIN, x2: WIDTH - MARGIN, y1: place, y2: place, stroke: '#ddd' });
    draw('text', { x: MARGIN - 8, y: place + 4, 'text-anchor': 'end' }, label);
  }
  draw('text', { x: WIDTH / 2, y: HEIGHT - 18, 'text-anchor': 'middle' }, columns[at(across.value)].title);
  draw('text', { x: 14, y: 16 }, columns[at(up.value)].title);
  const sign = HIGHER_IS_BETTER.includes(up.value) ? -1 : 1;
  const better = (a, b) => a.x <= b.x && sign * a.y <= sign * b.y && (a.x < b.x || a.y !== b.y);
  const best = points.filter((point) => !points.some((other) => better(other, point)));
  best.sort((a, b) => a.x - b.x || sign * (a.y - b.y));
  draw('polyline', {
    points: best.map((point) => `${x.place(point.x)},${y.place(point.y)}`).join(' '),
    fill: 'none', stroke: '#c2410c', 'stroke-width': 1.5,
  });
  // Names make way for each other, those on the frontier first.
  const named = [];
  for (const point of [...best, ...points.filter((other) => !best.includes(other))]) {
    const isBest = best.includes(point);
    const [left, top] = [x.place(point.x), y.place(point.y)];
    if (point.sure.length === 2) {
      const [from, to] = point.sure.map(x.place);
      draw('line', { x1: from, x2: to, y1: top, y2: top, stroke: '#94a3b8', 'stroke-width': 2 });
    }
    draw('circle', { cx: left, cy: top, r: isBest ? 5 : 4, fill: isBest ? '#c2410c' : '#64748b' });
    const wide = 7 * point.name.length + 10;
    const free = (at) => named.every(([l, t, w]) => left > l + w || left + wide < l || Math.abs(at - t) > 12);
    const places = [...Array(10).keys()].flatMap((step) => [top - 5 - 13 * step, top - 5 + 13 * step]);
    const place = places.find((at) => at > 24 && at < HEIGHT - MARGIN && free(at)) ?? top - 5;
    named.push([left, place, wide]);
    if (Math.abs(place - top + 5) > 14) {
      draw('line', { x1: left, y1: top, x2: left + 8, y2: place - 4, stroke: '#cbd5e1' });
    }
    draw('text', { x: left + 8, y: place, 'font-weight': isBest ? 600 : 400 }, point.name);
  }
  const names = best.map((point) => point.name).join(', ');
  frontier.textContent = `On the frontier, where no other method is better in both: ${names}.`;
};
[rows, across, up].forEach((select) => select.addEventListener('change', plotted));
plotted();
