#pragma once

namespace berg {

struct WindowContext;

/** Connects trade-off panel and tau curve with the planner in force, its curve and forecasts. */
void connectPlanner(WindowContext& context);
/** Connects playback bar, alarm strip and events with the mission. */
void connectPlayback(WindowContext& context);
/** Flies or continues; or pauses what is flying or played. */
void togglePlay(const WindowContext& context);

} // namespace berg
