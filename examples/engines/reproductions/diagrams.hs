-- ghc -v0 -o case case.hs
import Diagrams.Prelude
import Diagrams.ThreeD.Shapes (sphere)
main :: IO ()
main = case rayTraceP (mkP3 ({ox}) ({oy}) ({oz}) :: P3 Double) (mkR3 ({dx}) ({dy}) ({dz})) ball of
  Nothing -> putStrLn "miss"
  Just point -> let (x, y, z) = unp3 point in putStrLn (unwords (map show [x, y, z]))
  where ball = sphere # scale ({r}) # translate (mkR3 ({cx}) ({cy}) ({cz}))
