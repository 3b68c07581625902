namespace Msisf.Benchmarks;

/// <summary>A benchmark can't go on; the message says why.</summary>
internal sealed class BenchmarkException : Exception
{
    public BenchmarkException(string message, Exception? inner = null)
        : base(message, inner)
    {
    }
}
