import 'deciwatch-web/player';

const player = document.querySelector('deciwatch-player')!;
const input = document.querySelector('input')!;
const output = document.querySelector('output')!;

input.addEventListener('change', () => {
  const [file] = input.files ?? [];
  if (!file) return;
  player.srcObject = file;
  void player.play();
});

player.addEventListener('pose', ({ detail }) => {
  output.value = String((detail.frame ?? 0) + 1);
});
