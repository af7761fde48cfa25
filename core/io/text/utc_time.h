#pragma once

#include "core/scenario/utc_time.h" // the checks of scenarios read times too
