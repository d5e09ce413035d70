#pragma once
#include <QObject>

class QSocketNotifier;

namespace rasterlens
{

/// Brings the system's requests to end (SIGTERM, SIGINT, SIGHUP) into the event loop. A signal that was ignored when
/// the program started, as nohup does, stays ignored. At most one object at a time.
class EndSignals : public QObject
{
    Q_OBJECT

public:
    explicit EndSignals(QObject* parent = nullptr);
    ~EndSignals() override;

Q_SIGNALS:
    /// The program has five seconds to end by itself; then the system ends it. A second signal ends it at once.
    void received(int signal);

private:
    void read();

    int m_readEnd = -1;
    QSocketNotifier* m_notifier = nullptr;
};

} // namespace rasterlens
