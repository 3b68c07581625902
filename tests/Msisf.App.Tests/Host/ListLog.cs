using Msisf.App.Host;

namespace Msisf.App.Tests.Host;

/// <summary>A log that keeps its lines.</summary>
internal sealed class ListLog : ILog
{
    public List<string> Lines { get; } = [];

    public void Note(string text) => Lines.Add(text);

    public void Warning(string text) => Lines.Add($"warning: {text}");

    public void Error(string text) => Lines.Add($"error: {text}");

    public void Raw(string line) => Lines.Add(line);
}
