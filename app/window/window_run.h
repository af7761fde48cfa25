#pragma once

#include <QSize>
#include <QString>

#include <optional>

namespace berg {

/** How the window is opened. */
struct WindowOptions
{
    QString scenario;   ///< file to open; empty for the default scenario
    QString config;     ///< settings file in place of the user's own
    QString screenshot; ///< picture file to write before the program ends; empty to stay open
    std::optional<QSize>
        size_px;              ///< size; by default the last one, at first one that fits the screen
    std::optional<bool> dark; ///< dark or light; by default the user's choice
    double at_s = 0;          ///< mission time of the screenshot
    double wait_s = 0;        ///< longest wait for predictions and the bound before the screenshot
};

inline constexpr int kLongestScreenshotWait_s = 3600;

/** Runs the window until it is closed and returns the exit code of the program. */
int runWindow(const WindowOptions& options);

} // namespace berg
