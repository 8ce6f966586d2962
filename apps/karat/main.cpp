#include "apps/karat/run_karat.h"

int main(int argc, char** argv) { return karat::run_karat(argc, argv); }
