using Msisf.App.Preparation;

namespace Msisf.App.Rendering;

/// <summary>Writes the time of each frame to a file, one line per frame as soon as the frame is made. Thread-safe.</summary>
internal sealed class FrameTimes : IDisposable
{
    private readonly Lock _gate = new();
    private readonly StreamWriter? _file;
    private readonly string? _path;

    /// <summary>Creates the file.</summary>
    /// <param name="path">The file; null for none.</param>
    /// <exception cref="ExternalPartException">The file can't be written.</exception>
    public FrameTimes(string? path)
    {
        _path = path;
        _file = path is null ? null : Checked(() => new StreamWriter(path) { AutoFlush = true, NewLine = "\n" });
    }

    /// <summary>Writes the line of a frame.</summary>
    public void Add(Frame frame, TimeSpan time)
    {
        lock (_gate)
        {
            Checked(() =>
            {
                _file?.WriteLine(Invariant($"{frame.Step}\t{frame.Name}\t{time.TotalSeconds:F6}"));
                return true;
            });
        }
    }

    public void Dispose() => _file?.Dispose();

    private T Checked<T>(Func<T> work) => FileErrors.ToExternalPart($"--frame-times {_path}: can't be written", work);
}
