#include "core/builtin_scenes.h"
