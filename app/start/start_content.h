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

/** A file opened before, as it is now. */
struct RecentFile
{
    QString path;
    bool exists = false;
    QDateTime changed;
    std::optional<int> icebergs; ///< none: cannot be read
    QImage picture;              ///< of `kRecentPicture_px`; null: of no scenario or run
};

/** A scenario that comes with the program. */
struct Example
{
    QString path; ///< in the program's resources
    QString title;
    QString notes; ///< may be empty
    int icebergs = 0;
    QImage picture; ///< of `kExamplePicture_px` at the pixel ratio asked for
};

inline constexpr QSize kExamplePicture_px(252, 148);
inline constexpr QSize kRecentPicture_px(76, 54);

/** Paths of the examples, few icebergs first. */
[[nodiscard]] QStringList examplePaths();

/** Scenario of an example. Throws `Error`. Thread: any. */
[[nodiscard]] Scenario loadExample(const QString& path);

/**
 * Reads what the start page lists and paints the examples, planned, on a thread each: files may lie
 * on slow disks, and planning takes its time. GUI thread.
 */
class StartContent : public QObject
{
    Q_OBJECT

public:
    explicit StartContent(QObject* parent = nullptr);
    /** Stops the plan under way and waits for the file being read: a fraction of a second. */
    ~StartContent() override;

    /** Nothing more is wanted: deletes itself once nothing is under way, without waiting. */
    void finish();
    /** With their pictures. */
    void readRecent(const QStringList& paths, const Theme& theme, double pixelRatio);
    /** In place of what is being painted. */
    void paintExamples(const Theme& theme, double pixelRatio,
                       const QStringList& paths = examplePaths());

signals:
    // From the thread that reads: connect with a context object.
    void recentRead(const QList<berg::RecentFile>& files);
    /** `place` among the paths; `sea`: of the theme that it is painted in. */
    void examplePainted(int place, const berg::Example& example, const QColor& sea);

private:
    QThreadPool m_reader;
    QThreadPool m_painter;
    std::stop_source m_stop; ///< of what is being painted
};

} // namespace berg
