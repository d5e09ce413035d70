#include "core/camera.h"
