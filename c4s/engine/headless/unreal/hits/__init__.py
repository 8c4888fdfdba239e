"""What a query found, as scripts see it, and what a script's arguments mean to one."""
