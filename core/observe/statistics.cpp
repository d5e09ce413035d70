#include "core/observe/statistics.h"
