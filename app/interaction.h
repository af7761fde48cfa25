#pragma once

#include <QString>

class QWidget;

namespace berg {

/** Everything modal the window asks of a person, behind one interface so that tests can answer. */
class Interaction
{
public:
    enum class Unsaved
    {
        Save,
        Discard,
        Cancel
    };

    Interaction() = default;
    Interaction(const Interaction&) = delete;
    Interaction& operator=(const Interaction&) = delete;
    virtual ~Interaction() = default;

    /** The scenario has changes that are in no file. */
    [[nodiscard]] virtual Unsaved askUnsaved(QWidget* parent, const QString& name) = 0;
    /** Empty: cancelled. `filter` as in `QFileDialog`. */
    [[nodiscard]] virtual QString openPath(QWidget* parent, const QString& filter) = 0;
    [[nodiscard]] virtual QString savePath(QWidget* parent, const QString& suggested,
                                           const QString& filter) = 0;
    virtual void showError(QWidget* parent, const QString& text) = 0;
    virtual void showInformation(QWidget* parent, const QString& title, const QString& html) = 0;
};

/** The real one: Qt's dialogs. */
class DialogInteraction final : public Interaction
{
public:
    [[nodiscard]] Unsaved askUnsaved(QWidget* parent, const QString& name) override;
    [[nodiscard]] QString openPath(QWidget* parent, const QString& filter) override;
    [[nodiscard]] QString savePath(QWidget* parent, const QString& suggested,
                                   const QString& filter) override;
    void showError(QWidget* parent, const QString& text) override;
    void showInformation(QWidget* parent, const QString& title, const QString& html) override;
};

} // namespace berg
