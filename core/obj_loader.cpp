#include "core/obj_loader.h"
