#pragma once

#include "app/start/start_content.h"

#include <QAbstractButton>
#include <QLocale>

class QToolButton;

namespace berg {

/** Picture of an example with its title below; a click opens it. */
class ExampleCard : public QAbstractButton
{
    Q_OBJECT

public:
    explicit ExampleCard(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setExample(const Example& example);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Theme m_theme = Theme::light();
    Example m_example;
};

/** A file opened before: image, name, folder, when it was changed, how many icebergs; grey when
 * gone. */
class RecentRow : public QAbstractButton
{
    Q_OBJECT

public:
    RecentRow(const RecentFile& file, const Theme& theme, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    /** The file is gone and is not to be listed any more. */
    void removeRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    Theme m_theme;
    QImage m_image; ///< null if there is none
    QString m_folder;
    QString m_caption;
    QToolButton* m_remove = nullptr; ///< only when the file is gone
};

} // namespace berg
