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
 * Dialog that chooses format, content and file of an export and shows a preview. The runner, which
 * must outlive the dialog, does all work. The dialog writes no file.
 */
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    ExportDialog(MissionRunner& runner, const ExportOffer& offer, QWidget* parent = nullptr);
    /** Stops the preview in progress. */
    ~ExportDialog() override;

    /** Returns the request as entered in the dialog. */
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
    ExportPreviewPointer m_preview; ///< newest; null before the first
    QListWidget* m_formats = nullptr;
    ExportOptionsView* m_options = nullptr;
    QLabel* m_about = nullptr;
    ExportPreviewView* m_view = nullptr;
    QLabel* m_notes = nullptr;
    QLineEdit* m_path = nullptr;
    QTimer* m_pathPause = nullptr; ///< delays the check of a file name while it is typed
    QLabel* m_fileNote = nullptr;
    QPushButton* m_export = nullptr;
    QString m_suggested;       ///< path that the dialog proposed, to detect one typed by the user
    bool m_isAccepted = false; ///< Export was pressed and waits for the preview
};

} // namespace berg
