#include "core/case_file.h"
