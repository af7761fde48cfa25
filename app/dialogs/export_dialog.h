#pragma once

#include "app/dialogs/export_preview_view.h"
#include "app/dialogs/interaction.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace berg {

class ExportOptionsView;
class MissionRunner;

/**
 * Chooses the tool an export is for, what of the mission it is given and where the file goes, and
 * shows what comes of it. All work is the runner's, which is borrowed. Writes nothing itself.
 */
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    ExportDialog(MissionRunner& runner, const ExportOffer& offer, QWidget* parent = nullptr);
    /** Ends the work on what it would have shown. */
    ~ExportDialog() override;

    /** As it stands in the dialog. */
    [[nodiscard]] ExportRequest choice() const;

private:
    [[nodiscard]] QWidget* makeChoices();
    [[nodiscard]] QVBoxLayout* makeResult();
    [[nodiscard]] QLayout* makeFile();
    [[nodiscard]] QWidget* makeButtons();
    void addFormats();
    void chooseFormat(const std::string& id);
    void showFormat();
    [[nodiscard]] QString suggestedPath() const;
    void acceptChoice();
    [[nodiscard]] bool isUsable() const;
    void request();
    void take(const ExportPreviewPointer& preview);
    void showNotes(const ExportPreview& preview);
    void showState();
    void browse();
    [[nodiscard]] const ExportFormat& format() const;
    [[nodiscard]] QString fileFault() const;
    [[nodiscard]] QString filesText() const;

    MissionRunner& m_runner;
    ExportOffer m_offer;
    ExportPreviewPointer m_preview; ///< newest; null: none yet
    QListWidget* m_formats = nullptr;
    ExportOptionsView* m_options = nullptr;
    QLabel* m_about = nullptr;
    ExportPreviewView* m_view = nullptr;
    QLabel* m_notes = nullptr;
    QLineEdit* m_path = nullptr;
    QTimer* m_pathPause = nullptr; ///< until then the name of the file may still be typed
    QLabel* m_fileNote = nullptr;
    QPushButton* m_export = nullptr;
    QString m_suggested;       ///< path; another one was named by the user
    bool m_isAccepted = false; ///< and waits for the preview
};

} // namespace berg
