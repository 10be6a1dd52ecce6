import 'deciwatch-web/player';

const player = document.querySelector('deciwatch-player')!;
const input = document.querySelector('input')!;
const output = document.querySelector('output')!;

input.addEventListener('change', () => {
  player.srcObject = input.files?.[0] ?? null;
  void player.play();
});

player.addEventListener('pose', ({ detail }) => {
  output.value = String((detail.frame ?? 0) + 1);
});
