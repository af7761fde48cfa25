#pragma once

#include "app/layout/window_part.h"
#include "widgets/map/land/backdrop.h"
#include "widgets/tasks/latest_task.h"

namespace berg {

class MapController;

/** The file that is drawn below the map: chosen, read on a thread, remembered. */
class BackdropFile : public WindowPart
{
    Q_OBJECT

public:
    BackdropFile(WindowContext& context, MapController& map);

    void choose();

private:
    void open(const QString& path, bool isAsked);
    void remove();
    void show(const BackdropPointer& backdrop);
    void report(const WorkFailure& failure);

    MapController& m_map;
    QString m_path;                              ///< that is being read, or shown
    bool m_isAsked = false;                      ///< the user chose the file, so a failure is shown
    LatestTask<QString, BackdropPointer> m_task; ///< last: it ends before the rest
};

} // namespace berg
