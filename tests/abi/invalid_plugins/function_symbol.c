/* The symbol is there, but it is a function: its code read as data would be nonsense. */
__attribute__((visibility("default"))) int carom_shape_plugin_v1(void);
int carom_shape_plugin_v1(void) { return 42; }
