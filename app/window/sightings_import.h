#pragma once

#include "app/window/window_part.h"

namespace berg {

class ScenarioFiles;
class StartGuide;
struct ImportChoice;

/** Sightings of real icebergs from files of others; files dropped on the window. */
class SightingsImport : public WindowPart
{
    Q_OBJECT

public:
    SightingsImport(WindowContext& context, ScenarioFiles& files, StartGuide& start);

    void chooseSightings();
    void chooseAirspace();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] bool mayImport();
    void importSightings(const QString& path);
    void acceptImport(const ImportChoice& choice, const QString& fileName);
    void openDropped(const QString& path);

    ScenarioFiles& m_files;
    StartGuide& m_start;
};

} // namespace berg
