using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.Core.Scene;

namespace Msisf.Server.Basilisk;

/// <summary>
/// Writes the state of each image to a batch file, one for each camera, so that <c>msis --batch-file</c> draws the images again.
/// Thread-safe.
/// </summary>
internal sealed class StateRecord : IDisposable
{
    private readonly Lock _gate = new();
    private readonly string _folder;
    private readonly Dictionary<string, StreamWriter> _files = new(StringComparer.Ordinal);

    /// <summary>Begins a record.</summary>
    /// <param name="folder">The folder of the files; made if it is not there.</param>
    /// <exception cref="BadInputException">It can't be made.</exception>
    public StateRecord(string folder)
    {
        _folder = folder;
        FileErrors.ToBadInput(
            $"{ServeOptions.RecordFolder.Name} {folder}: can't be made", () => Directory.CreateDirectory(folder));
    }

    /// <summary>Adds a state.</summary>
    /// <param name="arguments">The canonical arguments of its images.</param>
    /// <param name="state">The state, with its Sun.</param>
    public void Add(long cameraId, Func<string> arguments, SpacecraftState state)
    {
        string name = Invariant($"camera-{cameraId}.csv");
        lock (_gate)
        {
            if (!_files.TryGetValue(name, out StreamWriter? file))
            {
                file = new StreamWriter(Path.Combine(_folder, name)) { NewLine = "\n", AutoFlush = true };
                _files.Add(name, file);
                string head = $"drawn again by: msis {arguments()} --batch-file {name}";
                using StringWriter first = new(CultureInfo.InvariantCulture) { NewLine = "\n" };
                BatchFileWriter.Write(first, head, [state]);
                file.Write(first);
                return;
            }

            using StringWriter text = new(CultureInfo.InvariantCulture) { NewLine = "\n" };
            BatchFileWriter.Write(text, string.Empty, [state]);
            file.WriteLine(text.ToString().TrimEnd('\n').Split('\n')[^1]);
        }
    }

    /// <summary>Closes the files.</summary>
    public void Dispose()
    {
        foreach (StreamWriter file in _files.Values)
        {
            file.Dispose();
        }
    }
}
