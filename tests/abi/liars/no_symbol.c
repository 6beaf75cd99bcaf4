/* A shared object of something else. */
int carom_liar_something_else = 1;
