namespace Msisf.Core.Surface.Sources;

/// <summary>Numbers that are put together into groups.</summary>
internal sealed class UnionFind
{
    private readonly int[] _next;

    /// <summary>Begins with each number alone.</summary>
    /// <param name="count">How many numbers, from 0.</param>
    public UnionFind(int count) => _next = [.. Enumerable.Range(0, count)];

    /// <summary>A number of the group of a number, the same for all of the group.</summary>
    public int Of(int number)
    {
        while (_next[number] != number)
        {
            _next[number] = _next[_next[number]];
            number = _next[number];
        }

        return number;
    }

    /// <summary>Puts the groups of two numbers together.</summary>
    public void Unite(int one, int other) => _next[Of(one)] = Of(other);
}
