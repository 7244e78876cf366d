#include "core/trace/event.h"

#include <format>
