namespace Msisf.Stress;

/// <summary>What a part of a stress test keeps of its cases; each thread fills its own.</summary>
/// <typeparam name="TSelf">The class itself.</typeparam>
public interface IMeasure<TSelf>
    where TSelf : IMeasure<TSelf>
{
    /// <summary>Tries a case.</summary>
    /// <param name="number">Of the case, from 0: kinds take turns by it.</param>
    /// <param name="random">Draws the input.</param>
    void Try(int number, CaseRandom random);

    /// <summary>Notes the cases of another, which come after its own.</summary>
    void Add(TSelf other);
}
