#pragma once

#include <QString>
#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;

namespace berg {

/** What an id is of: begins the names of the inputs, and its tool tip. */
struct IdWords
{
    QString key;
    QString toolTip;
};

/**
 * The id of one iceberg or UAV. Says at once when what is typed cannot be an id, and goes back to
 * the id there is when typing ends with such a text.
 */
class IdField : public QWidget
{
    Q_OBJECT

public:
    /** `whyNot(id)` is a sentence for an id that cannot be given, empty for one that can. */
    IdField(const IdWords& words, std::function<QString(const QString& id)> whyNot,
            QWidget* parent = nullptr);

    void showId(const QString& id);
    void setLocked(bool locked);
    /** Takes what is typed as if Return had been pressed. */
    void finishTyping();

signals:
    void edited(const QString& id);

private:
    void say(const QString& fault);

    std::function<QString(const QString&)> m_whyNot;
    QLineEdit* m_line;
    QLabel* m_fault;
    QString m_id;
};

} // namespace berg
