#pragma once

#include "app/interaction.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace berg {

/** Chooses the tool an export is for, says what that tool is given, and where the file goes. */
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    explicit ExportDialog(const ExportOffer& offer, QWidget* parent = nullptr);

    /** As it stands in the dialog. */
    [[nodiscard]] ExportChoice choice() const;

private:
    void addFormats();
    void addFile();
    void addButtons();
    void showFormat();
    void showFile();
    void browse();
    [[nodiscard]] QString formatId() const;

    ExportOffer m_offer;
    QListWidget* m_formats;
    QLabel* m_about;
    QLineEdit* m_path;
    QLabel* m_note;
    QPushButton* m_export;
};

} // namespace berg
