using System.Reflection;
using Xunit;

namespace Msisf.Architecture.Tests
{
    /// <summary>No namespace uses another in a circle.</summary>
    public sealed class NamespaceCycleTests
    {
        [Theory]
        [InlineData("Msisf.Core")]
        [InlineData("Msisf.Synthesis")]
        [InlineData("Msisf.Adapters")]
        [InlineData("Msisf.MySql")]
        [InlineData("Msisf.App")]
        [InlineData("msis")]
        public void Namespaces_DoNotUseEachOther_InACircle(string assembly)
        {
            IReadOnlyList<string> cycles = new NamespaceGraph(Assembly.Load(assembly).GetTypes()).Cycles();

            Assert.True(cycles.Count == 0, $"{assembly}:\n{string.Join('\n', cycles)}");
        }

        /// <summary>The test of the test: a way through a method's body, a signature, and a type argument of a field.</summary>
        [Fact]
        public void Cycles_OfACircleOfThree_NamesItAndWhoMakesIt()
        {
            IEnumerable<Type> circle = typeof(NamespaceCycleTests).Assembly.GetTypes()
                .Where(type => type.Namespace?.StartsWith("Circle.", StringComparison.Ordinal) == true);

            string cycle = Assert.Single(new NamespaceGraph(circle).Cycles());

            Assert.Equal(
                "Circle.A -> Circle.B (by InBody's InSignature) -> Circle.C (by InSignature's InField) -> Circle.A (by InField's InBody)",
                cycle);
        }

        [Fact]
        public void Cycles_OfANamespaceAndOneInsideIt_AreNone() =>
            Assert.Empty(new NamespaceGraph([typeof(Circle.A.InBody), typeof(Circle.A.Inside.User)]).Cycles());
    }
}

namespace Circle.A
{
    internal sealed class InBody
    {
        public static string Name() => new B.InSignature().ToString()!;

        public static Type Part() => typeof(Inside.User);
    }
}

namespace Circle.A.Inside
{
    internal static class User
    {
        public static string Name() => InBody.Name();
    }
}

namespace Circle.B
{
    internal sealed class InSignature
    {
        public static void Take(C.InField _)
        {
        }
    }
}

namespace Circle.C
{
    internal sealed class InField
    {
        public IReadOnlyList<Func<A.InBody>> Parts { get; } = [];
    }
}
