"""The paper's studies on our own data, and the document that is made of them."""
