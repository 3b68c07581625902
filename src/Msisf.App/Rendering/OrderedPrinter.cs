namespace Msisf.App.Rendering;

/// <summary>
/// Prints the results of steps in the order of the steps, each as early as possible, whatever order they end in. Thread-safe.
/// </summary>
internal sealed class OrderedPrinter
{
    private readonly Lock _gate = new();
    private readonly TextWriter _results;
    private readonly IReadOnlyList<string>?[] _waiting;
    private int _next;

    public OrderedPrinter(TextWriter results, int steps)
    {
        _results = results;
        _waiting = new IReadOnlyList<string>?[steps];
    }

    /// <summary>Reports that a step is done.</summary>
    /// <param name="index">Index of the step, from 0.</param>
    /// <param name="lines">The lines of the step; empty if it failed.</param>
    public void Done(int index, IReadOnlyList<string> lines)
    {
        lock (_gate)
        {
            _waiting[index] = lines;
            while (_next < _waiting.Length && _waiting[_next] is IReadOnlyList<string> ready)
            {
                foreach (string line in ready)
                {
                    _results.WriteLine(line);
                }

                _waiting[_next] = [];
                _next++;
            }

            _results.Flush();
        }
    }
}
