/* A shared object of something else. */
int carom_invalid_something_else = 1;
