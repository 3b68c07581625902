namespace Msisf.Stress;

/// <summary>What a part of a stress test keeps of its cases; each thread fills its own.</summary>
/// <typeparam name="TSelf">The class itself.</typeparam>
public interface IMeasure<TSelf>
    where TSelf : IMeasure<TSelf>
{
    /// <summary>The worst of each quantity.</summary>
    IEnumerable<StressFigure> Figures { get; }

    /// <summary>Errors over the range of an input.</summary>
    IEnumerable<StressSeries> Series { get; }

    /// <summary>Tries a case.</summary>
    /// <param name="number">Of the case, from 0: kinds take turns by it.</param>
    /// <param name="random">Draws the input.</param>
    void Try(int number, Random random);

    /// <summary>Notes the cases of another.</summary>
    void Add(TSelf other);
}
