#pragma once

#include "app/dialogs/import_dialog.h"
#include "tests/support/files/import_fixtures.h"
#include "tests/support/window/panel_test.h"
#include "widgets/map/view/map_view.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

namespace berg::test {

inline QString fixturePath(const char* file)
{
    return QStringLiteral(BERG_TEST_DATA "/import/") + QString::fromLatin1(file);
}

/** The dialog alone, with its own runner. */
class Importing
{
public:
    explicit Importing(const QString& path, const Scenario& present = openSea(),
                       bool intoNew = false)
        : m_dialog(m_runner, {.path = path,
                              .present = std::make_shared<const Scenario>(present),
                              .intoNew = intoNew,
                              .theme = Theme::light()})
    {
        m_dialog.show();
    }

    [[nodiscard]] ImportDialog& dialog() { return m_dialog; }
    [[nodiscard]] ImportRunner& runner() { return m_runner; }
    [[nodiscard]] bool settles()
    {
        return QTest::qWaitFor([this] { return !m_runner.isBusy(); }, 60000);
    }
    template <class Widget>
    [[nodiscard]] Widget& at(const QString& name)
    {
        return child<Widget>(m_dialog, name);
    }
    [[nodiscard]] QAbstractItemModel& rows(const QString& table)
    {
        return *at<QTableView>(table).model();
    }
    [[nodiscard]] QString cell(const QString& table, int row, int column)
    {
        return rows(table).index(row, column).data().toString();
    }
    [[nodiscard]] bool canImport()
    {
        return at<QPushButton>(QStringLiteral("importButton")).isEnabled();
    }
    [[nodiscard]] QString error() { return at<QLabel>(QStringLiteral("importError")).text(); }
    [[nodiscard]] QString summary() { return at<QLabel>(QStringLiteral("importSummary")).text(); }
    /** Chooses an entry as the user does, which also notifies the dialog. */
    void choose(const QString& combo, int index)
    {
        auto& box = at<QComboBox>(combo);
        box.setCurrentIndex(index);
        emit box.activated(index);
    }
    void check(const QString& box) { at<QCheckBox>(box).click(); }
    void setTime(const QString& name, const char* text)
    {
        check(name + QStringLiteral("Box"));
        enter(at<QLineEdit>(name), QString::fromLatin1(text));
    }

    /** Opens a list; Escape then closes the list and not the dialog. */
    [[nodiscard]] bool escapeClosesListAlone(const QString& combo)
    {
        auto& box = at<QComboBox>(combo);
        const QWidget& list = *box.view();
        box.setFocus();
        QTest::keyClick(&box, Qt::Key_Space);
        if (!QTest::qWaitFor([&list] { return list.isVisible(); }))
            return false;
        QTest::keyClick(box.view(), Qt::Key_Escape);
        return QTest::qWaitFor([&list] { return !list.isVisible(); }) && m_dialog.isVisible();
    }

private:
    ImportRunner m_runner;
    ImportDialog m_dialog;
};

inline QString written(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", qPrintable(path));
    return path;
}

/** Returns the result of importing the file without a dialog. */
inline ImportResult direct(const char* file, const Scenario& base,
                           const ImportOptions& options = {})
{
    return importSightings(base, readFixture(file), options);
}

} // namespace berg::test
