import './app.css';
import './deciwatch-app.ts';
