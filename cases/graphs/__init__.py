"""From what an author or a model says of a prompt to a requirement bundle in the published format."""
