namespace Msisf.App.Host;

/// <summary>
/// Shows progress as plain lines with the remaining time, for files and unattended runs; at most one line every few seconds.
/// </summary>
internal sealed class PlainProgress : IRunProgress
{
    private static readonly TimeSpan MinPause = TimeSpan.FromSeconds(2.0);

    private readonly Lock _gate = new();
    private readonly ILog _log;
    private readonly TimeProvider _clock;
    private readonly int _total;
    private readonly long _start;
    private long _lastLine;
    private int _done;

    public PlainProgress(ILog log, TimeProvider clock, int total)
    {
        _log = log;
        _clock = clock;
        _total = total;
        _start = clock.GetTimestamp();
        _lastLine = _start;
    }

    public void Advance(string name)
    {
        lock (_gate)
        {
            _done++;
            if (_done < _total && _clock.GetElapsedTime(_lastLine) < MinPause)
            {
                return;
            }

            _lastLine = _clock.GetTimestamp();
            TimeSpan left = _clock.GetElapsedTime(_start) * ((double)(_total - _done) / _done);
            _log.Note(Invariant($"{_done} of {_total} done ({name}), {left:hh\\:mm\\:ss} left"));
        }
    }

    public void Dispose()
    {
    }
}
