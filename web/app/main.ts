import './app.css';
import './deciwatch-app.ts';
import './offline/keep-offline.ts';
