#pragma once

#include "core/scenario/scenario.h"
#include "widgets/theme/theme.h"

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <QThreadPool>

#include <optional>
#include <stop_token>

namespace berg {

/** A recent file in its present state. */
struct RecentFile
{
    QString path;
    bool exists = false;
    QDateTime changed;
    std::optional<int> icebergs; ///< nullopt if the file cannot be read
    QImage image; ///< of size `kRecentImage_px`; null if the file is no scenario or run
};

/** A scenario that comes with the program. */
struct Example
{
    QString path; ///< in the program's resources
    QString title;
    QString notes; ///< may be empty
    int icebergs = 0;
    QImage image; ///< of size `kExampleImage_px` at the requested pixel ratio
};

inline constexpr QSize kExampleImage_px(252, 148);
inline constexpr QSize kRecentImage_px(76, 54);

/** Returns the paths of the examples, those with few icebergs first. */
[[nodiscard]] QStringList examplePaths();

/** Returns the scenario of an example. Throws `Error`. Any thread. */
[[nodiscard]] Scenario loadExample(const QString& path);

/**
 * Reads recent files and plans and paints the examples, on one thread each, because disks can be
 * slow and planning takes time. Call it from the GUI thread.
 */
class StartContent : public QObject
{
    Q_OBJECT

public:
    explicit StartContent(QObject* parent = nullptr);
    /** Stops the current plan and waits for the current file, a fraction of a second. */
    ~StartContent() override;

    /** Deletes the object without blocking, after its work has ended. */
    void finish();
    /** Starts to read recent files and their pictures. */
    void readRecent(const QStringList& paths, const Theme& theme, double pixelRatio);
    /** Starts to paint the examples and drops earlier requests. */
    void paintExamples(const Theme& theme, double pixelRatio,
                       const QStringList& paths = examplePaths());

signals:
    // These are emitted by the reading thread: connect with a context object.
    void recentRead(const QList<berg::RecentFile>& files);
    /** `place` among the paths; `sea`: of the theme that it is painted in. */
    void examplePainted(int place, const berg::Example& example, const QColor& sea);

private:
    QThreadPool m_reader;
    QThreadPool m_painter;
    std::stop_source m_stop; ///< stops painting
};

} // namespace berg
