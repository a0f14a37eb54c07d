'use strict';
// Sorts and filters the table, and plots its rows. The table's cells are the only data.
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
  // Rows without the figure come last in either order.
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

const [rows, across, up] = ['rows', 'across', 'up'].map((id) => document.getElementById(id));
const offer = (select, names, chosen) => names.forEach(([key, title]) => {
  select.add(new Option(title, key, key === chosen, key === chosen));
});
const named = (keys) => keys.map((key) => [key, columns[at(key)].title]);
// Settings by which methods are compared, each with the column that separates groups on other axes.
const AXES = {
  map_texels: 'map_size',
  steps: 'steps',
  scale_m: 'scale_m',
  angle_deg: 'angle_deg',
  distance_m: 'distance_m',
};
// Returns NaN if a row has no such figure.
const figure = (row, key) => {
  const place = at(key);
  return row.cells[place].textContent === '' ? NaN : value(row, place) * columns[place].factor;
};
// A group holds rows that can be compared: the same rays, or pictures of the same scene, except for the
// setting on the horizontal axis.
const groupOf = (row) => ['kind', 'map_size', 'scale_m', 'angle_deg', 'distance_m', 'backend', 'sampling']
  .filter((key) => key !== AXES[across.value])
  .map((key) => [columns[at(key)].title, row.cells[at(key)].textContent])
  .filter(([, text]) => text !== '')
  .map(([title, text]) => (/^[a-z]+$/.test(text) ? text : `${title} ${text}`)).join(', ');
// Offers the groups with both figures, and keeps the selected one if it is still there.
const grouped = () => {
  const before = rows.value;
  const has = (row) => [across, up].every((select) => Number.isFinite(figure(row, select.value)));
  const groups = [...new Set([...body.rows].filter(has).map(groupOf))];
  // A plot begins with rays between 30 and 60 degrees, at which reliefs are mostly
  // seen, and the greatest scale.
  const isUsual = (row) => figure(row, 'angle_deg') >= 30 && figure(row, 'angle_deg') <= 60;
  const ofRays = (some) => [...new Set([...body.rows].filter((row) => has(row) && some(row)).map(groupOf))]
    .filter((group) => group.startsWith('rays'));
  const usual = [ofRays(isUsual), ofRays(() => true), groups].find((some) => some.length)?.at(-1);
  rows.replaceChildren();
  offer(rows, groups.map((group) => [group, group]), groups.includes(before) ? before : usual);
};
const COSTS = ['reads', 'p99_reads', 'wave_reads', 'turns', 'bytes', 'displacement_ms', 'frame_ms',
  'shadow_ms', 'map_bytes', 'bake_seconds'];
offer(across, named([...COSTS, ...Object.keys(AXES)]), 'reads');
offer(up, named(['p99_texels', 'median_texels', 'mean_texels', 'passed', 'flip', 'ssim', 'psnr_db', 'rms',
  'flicker_rms', 'flicker_flip', ...COSTS]), 'p99_texels');

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
// Returns a logarithmic scale. Numbers that are not above 0 are drawn one step before the least other one.
const scale = (numbers, from, to) => {
  const positive = numbers.filter((number) => number > 0);
  const hasZero = positive.length < numbers.length;
  const ends = hasZero ? [...positive, 1] : positive;
  const [least, most] = [Math.min(...ends), Math.max(...ends)].map(Math.log10);
  const low = Math.floor(least) - (hasZero ? 1 : 0);
  const high = Math.max(Math.ceil(most), low + (hasZero ? 2 : 1));
  const place = (exponent) => from + (to - from) * (exponent - low) / (high - low);
  const ticks = [];
  const parts = high - low > 3 ? [1] : [1, 2, 5];
  for (let exponent = low; exponent <= high; exponent += 1) {
    const isZero = hasZero && exponent === low;
    for (const part of isZero ? [1] : parts) {
      const at = exponent + Math.log10(part);
      const written = Number((part * 10 ** exponent).toPrecision(1));
      const decimal = exponent < -4 ? written.toExponential() : String(written);
      const label = isZero ? '0' : decimal;
      if (at <= high) ticks.push([place(at), label]);
    }
  }
  return { ticks, place: (number) => (number > 0 ? place(Math.log10(number)) : from) };
};
const plotted = () => {
  const isAxis = across.value in AXES;
  const points = [...body.rows].filter((row) => groupOf(row) === rows.value).map((row) => {
    const said = ['steps', 'map_format', 'shadow'].filter((key) => key !== across.value)
      .map((key) => row.cells[at(key)].textContent).filter(Boolean).join(', ');
    return {
      name: row.cells[at('method')].textContent + (said ? ` (${said})` : ''),
      x: figure(row, across.value),
      y: figure(row, up.value),
      // Ends of the interval of a median, if it has one.
      sure: ['low', 'high'].map((end) => at(across.value.replace('_ms', `_${end}_ms`)))
        .filter((place) => place >= 0 && place !== at(across.value))
        .map((place) => value(row, place) * columns[place].factor),
    };
  }).filter((point) => Number.isFinite(point.x) && Number.isFinite(point.y));
  svg.replaceChildren();
  const frontier = document.getElementById('frontier');
  frontier.textContent = points.length ? '' : 'No rows have both figures: choose other axes.';
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
  const best = isAxis ? [] : points.filter((point) => !points.some((other) => better(other, point)));
  best.sort((a, b) => a.x - b.x || sign * (a.y - b.y));
  const line = (of, colour) => draw('polyline', {
    points: of.map((point) => `${x.place(point.x)},${y.place(point.y)}`).join(' '),
    fill: 'none', stroke: colour, 'stroke-width': 1.5,
  });
  line(best, '#c2410c');
  // With a setting on the horizontal axis, each method is a line with its name at the end.
  const series = isAxis ? [...new Set(points.map((point) => point.name))].map((name) => (
    points.filter((point) => point.name === name).sort((a, b) => a.x - b.x))) : [];
  series.forEach((of) => line(of, '#94a3b8'));
  const ends = series.map((of) => of[of.length - 1]);
  // Names avoid each other; names on the frontier are placed first.
  const named = [];
  for (const point of [...best, ...points.filter((other) => !best.includes(other))]) {
    const isBest = best.includes(point);
    const [left, top] = [x.place(point.x), y.place(point.y)];
    if (point.sure.length === 2) {
      const [from, to] = point.sure.map(x.place);
      draw('line', { x1: from, x2: to, y1: top, y2: top, stroke: '#94a3b8', 'stroke-width': 2 });
    }
    draw('circle', { cx: left, cy: top, r: isBest ? 5 : 4, fill: isBest ? '#c2410c' : '#64748b' });
    if (isAxis && !ends.includes(point)) continue;
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
  frontier.textContent = isAxis ? 'Each line is a method.'
    : `Best trade-offs, for which no other method is better in both figures: ${names}.`;
};
[across, up].forEach((select) => select.addEventListener('change', () => { grouped(); plotted(); }));
rows.addEventListener('change', plotted);
// The page's address can select the first plot, as in #across=map_texels&up=frame_ms.
const asked = new URLSearchParams(location.hash.slice(1));
[across, up].forEach((select) => {
  const key = asked.get(select.id);
  if ([...select.options].some((option) => option.value === key)) select.value = key;
});
grouped();
if ([...rows.options].some((option) => option.value === asked.get('rows'))) rows.value = asked.get('rows');
plotted();
