#pragma once

#include <QSettings>
#include <QTemporaryDir>

#include <array>
#include <optional>

namespace berg {

/** Of text and all else, per cent of what the system has; the sizes to choose from. */
inline constexpr const char* kScaleKey = "view/scale";
inline constexpr std::array kScales_percent = {100, 125, 150, 175, 200};

/**
 * The settings of one run of the program, and where it keeps what belongs to them. GUI thread.
 *
 * A picture shows the program as it comes, or as the file says, and changes neither: its settings
 * are in a folder that goes with the run. So are those of a `config` that is there but is no
 * ordinary file, such as /dev/null: `QSettings` would put a file in its place.
 */
class RunSettings
{
public:
    /** `config`: a file in place of the user's own settings; empty: none. */
    RunSettings(const QString& config, bool isPicture);

    [[nodiscard]] QSettings& settings() { return *m_settings; }
    /**
     * What is written in that file of the size of text and all else, in per cent; 100: nothing is.
     * Before there is an application, whose scale it decides.
     */
    [[nodiscard]] static int savedScale_percent(const QString& config);

    /** Where unsaved work and locks are kept. */
    [[nodiscard]] const QString& dataFolder() const { return m_dataFolder; }

private:
    std::optional<QTemporaryDir> m_folder; ///< outlives the settings, which write at their end
    std::optional<QSettings> m_settings;
    QString m_dataFolder;
};

} // namespace berg
