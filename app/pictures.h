#pragma once

#include "core/sim/mission.h"

#include <QLocale>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace berg {

/** Which appearance pictures are made in. */
enum class PictureTheme
{
    Light,
    Dark,
    Both
};

struct PictureOptions
{
    QString folder;
    std::optional<QSize> size_px; ///< of every picture; none: 1600 x 1000 maps, 1600 x 700 charts
    PictureTheme theme = PictureTheme::Light;
};

/** Smallest and largest side of a picture, pixels. */
inline constexpr int kSmallestPicture_px = 100;
inline constexpr int kLargestPicture_px = 8192;

/**
 * The mission of a scenario, flown to its end, or of a run, flown again to where it was left.
 * Throws `Error` for files that are neither, invalid or unreadable, and ReplayMismatch when the run
 * does not come out as recorded.
 */
[[nodiscard]] Mission flownMission(const std::string& path);

/** Of the files that are written into the folder. */
[[nodiscard]] QStringList pictureNames(PictureTheme theme);

/**
 * Writes all or none: map.png, zeta.png and sigma.png (`-dark` appended for the dark appearance
 * when both are asked for) into the folder, which is made when missing. Returns the paths written.
 * Throws `Error{FileUnwritable}`. Needs a QApplication.
 */
QStringList writePictures(const Mission& mission, const PictureOptions& options,
                          const QLocale& locale);

} // namespace berg
